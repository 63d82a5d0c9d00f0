#include <fmt/format.h>

#include "mechanism/joints/joint_types.h"
#include "scene/element_readers.h"

namespace clevis::scene {
namespace {

using namespace mechanism;

enum class Needs { kAnyLine, kFixedAxis };

/// `joint` and perhaps `coordinate`, or `between` with `from`, `to` and perhaps
/// `axis`.
ElementLine read_line(StrictTable& table,
                      const std::vector<JointDefinition>& joints,
                      const Names& names, Needs needs) {
  ElementLine line;
  if (const auto joint = table.find("joint")) {
    line.kind = ElementLine::Kind::kJoint;
    line.joint = names.joints.find(joint->name(), *joint);
    const auto& definition = joints[static_cast<std::size_t>(line.joint)];
    if (coordinates(definition.type).empty()) {
      throw joint->refusal("S010", "has no coordinate",
                           "Name a joint that moves.");
    }
    if (const auto coordinate = table.find("coordinate")) {
      line.coordinate = find_coordinate(*coordinate, definition);
    }
    return line;
  }
  const Value between = table["between"];
  const auto bodies = between.elements(2);
  line.a.body = find_body_or_ground(bodies[0], names);
  line.b.body = find_body_or_ground(bodies[1], names);
  if (line.a.body == line.b.body) {
    throw between.refusal("S010", "names one body twice",
                          "Name two different bodies, one may be \"ground\".");
  }
  line.a.p_L = table["from"].vector(Dimension::kLength);
  line.b.p_L = table["to"].vector(Dimension::kLength);
  line.kind = ElementLine::Kind::kDistance;
  const auto axis = needs == Needs::kFixedAxis ? std::optional(table["axis"])
                                               : table.find("axis");
  if (axis) {
    line.kind = ElementLine::Kind::kSlide;
    line.axis_L = axis->direction();
  }
  return line;
}

SpringLaw read_spring(StrictTable& table, const LineUnits& units) {
  SpringLaw law;
  if (const auto stiffness = table.find("stiffness")) {
    law.stiffness = plausible_stiffness_or_zero(*stiffness, units.stiffness);
  }
  law.damping = not_negative_or(table, "damping", units.damping, 0.0);
  if (!table.has("stiffness") && !table.has("damping")) {
    throw table.refusal("S003", "lacks the key \"stiffness\" or \"damping\"",
                        "Give a spring, a damper or both.");
  }
  // of a stiffness of zero it means nothing, but may stand
  const bool of_zero = table.has("stiffness") && table.has("free");
  if (law.stiffness > 0.0 || of_zero) {
    law.free = table["free"].quantity(units.coordinate);
  }
  if (const auto preload = table.find("preload")) {
    law.preload = preload->quantity(units.effort);
  }
  if (law.stiffness == 0.0 && law.damping == 0.0 && law.preload == 0.0) {
    throw table.refusal(
        "S006",
        "has neither stiffness nor damping nor preload: all are "
        "zero",
        "Give one above zero, or remove the force.");
  }
  return law;
}

/// Friction that follows the force of its joint: coefficients, and where the
/// joint turns the radius of the pin.
void read_following(StrictTable& table, const ElementLine& line,
                    const std::vector<JointDefinition>& joints,
                    FrictionLaw& law) {
  const Value kinetic = table["kinetic_friction"];
  law.follows_reaction = true;
  law.kinetic = kinetic.number(0.0, 100.0);
  const auto at_rest = table.find("static_friction");
  law.breakaway = at_rest ? at_rest->number(0.0, 100.0) : law.kinetic;
  if (law.kinetic > law.breakaway) {
    throw kinetic.refusal("S006", "is above the static friction",
                          "Friction at rest is at least that in motion.");
  }
  if (line.kind != ElementLine::Kind::kJoint ||
      !mechanism::traits(joints[static_cast<std::size_t>(line.joint)].type)
           .takes_reaction_friction) {
    throw kinetic.refusal("S010", "follows the force of no such joint",
                          "Name a revolute, prismatic or cylindrical joint.");
  }
  if (law.model == FrictionModel::kLuGre) {
    throw kinetic.refusal("S010", "is not for bristles",
                          "Choose the model \"coulomb\" or \"regularized\".");
  }
  if (!is_angle(line, joints)) return;
  const double radius = table["pin_radius"].positive(Dimension::kLength);
  law.kinetic *= radius;
  law.breakaway *= radius;
}

void read_given_friction(StrictTable& table, const LineUnits& units,
                         FrictionLaw& law) {
  const Value breakaway = table["breakaway"];
  law.breakaway = not_negative(breakaway, units.effort);
  law.kinetic = not_negative(table["kinetic"], units.effort);
  if (law.kinetic > law.breakaway) {
    throw breakaway.refusal("S006", "is below the kinetic friction",
                            "Friction at rest is at least that in motion.");
  }
  if (law.model == FrictionModel::kLuGre && !(law.kinetic > 0.0)) {
    throw breakaway.refusal("S006", "with kinetic = 0 has no bristles",
                            "Give a kinetic friction above zero.");
  }
}

FrictionLaw read_friction(StrictTable& table, const ElementLine& line,
                          const std::vector<JointDefinition>& joints) {
  const LineUnits units = line_units(is_angle(line, joints));
  FrictionLaw law;
  if (const auto model = table.find("model")) {
    law.model = model->choice<FrictionModel>(
        {{"coulomb", FrictionModel::kCoulomb},
         {"regularized", FrictionModel::kRegularized},
         {"lugre", FrictionModel::kLuGre}});
  }
  if (table.has("kinetic_friction")) {
    read_following(table, line, joints, law);
  } else {
    read_given_friction(table, units, law);
  }
  law.viscous = not_negative_or(table, "viscous", units.damping, 0.0);
  law.stribeck_speed =
      not_negative_or(table, "stribeck_speed", units.rate, 0.0);
  if (law.model == FrictionModel::kRegularized) {
    law.regularizing_speed = table["regularizing_speed"].positive(units.rate);
  } else if (law.model == FrictionModel::kLuGre) {
    law.bristle_stiffness =
        plausible_stiffness(table["bristle_stiffness"], units.stiffness);
    law.bristle_damping = not_negative(table["bristle_damping"], units.damping);
  }
  return law;
}

/// Two or more, far enough apart to be told apart as a motion passes.
std::vector<double> increasing_positions(const Value& value,
                                         Dimension dimension) {
  std::vector<double> positions;
  for (const Value& each : value.elements()) {
    positions.push_back(each.quantity(dimension));
    constexpr double kApart = 1e-9;  // [m] or [rad]
    const std::size_t n = positions.size();
    if (n > 1 && !(positions[n - 1] - positions[n - 2] > kApart)) {
      throw each.refusal("S006", "does not increase",
                         "Give positions that increase.");
    }
  }
  if (positions.size() < 2) {
    throw value.refusal("S006", "has fewer than two entries",
                        "Give two positions or more.");
  }
  return positions;
}

TableLaw read_table(StrictTable& table, const LineUnits& units) {
  TableLaw law;
  if (table.has("positions")) {
    law.positions = increasing_positions(table["positions"], units.coordinate);
  } else {
    law.times = increasing_times(table["times"], 1, Steps::kAllowed);
  }
  const Value efforts = table["efforts"];
  for (const Value& e : efforts.elements()) {
    law.efforts.push_back(e.quantity(units.effort));
  }
  const bool over_time = law.positions.empty();
  const std::size_t points =
      over_time ? law.times.size() : law.positions.size();
  if (points != law.efforts.size()) {
    throw efforts.refusal(
        "S010",
        fmt::format("has {} entries for {} {}", law.efforts.size(), points,
                    over_time ? "times" : "positions"),
        "Give one effort for each.");
  }
  return law;
}

/// On which sense of motion an element acts.
void read_sense(StrictTable& table, const LineUnits& units,
                LineElement& element) {
  const auto acts_on = table.find("acts_on");
  if (!acts_on) return;
  element.acts_on =
      acts_on->choice<ActsOn>({{"both", ActsOn::kBoth},
                               {"increasing", ActsOn::kIncreasing},
                               {"decreasing", ActsOn::kDecreasing}});
  if (element.acts_on == ActsOn::kBoth) return;
  if (const auto speed = table.find("full_speed")) {
    element.full_speed = speed->positive(units.rate);
  }
}

ServoLaw read_servo_on(StrictTable& table, const ElementLine& line,
                       const std::vector<JointDefinition>& joints) {
  if (line.kind != ElementLine::Kind::kJoint) {
    throw table.refusal("S010", "acts between points",
                        "A servo moves the coordinate of a joint.");
  }
  const bool angle = is_angle(line, joints);
  return read_servo(table, line_units(angle),
                    angle ? Dimension::kMassMoment : Dimension::kMass);
}

bool is_revolute(const ElementLine& line,
                 const std::vector<JointDefinition>& joints) {
  return line.kind == ElementLine::Kind::kJoint &&
         mechanism::traits(joints[static_cast<std::size_t>(line.joint)].type)
             .is_hinge();
}

double of_a_machine(const Value& value, double stiffness) {
  constexpr double kStiffest = 1e15;  // N/m or N m/rad
  if (stiffness <= kStiffest) return stiffness;
  throw value.refusal("S011", "is stiffer than any machine",
                      "Check the number and its unit.");
}

}  // namespace

/// A quantity that may be zero but not negative.
double not_negative(const Value& value, Dimension dimension) {
  const double number = value.quantity(dimension);
  if (number < 0.0) {
    throw value.refusal("S006", "is negative", "Give zero or more.");
  }
  return number;
}

double plausible_stiffness(const Value& value, Dimension dimension) {
  return of_a_machine(value, value.positive(dimension));
}

double plausible_stiffness_or_zero(const Value& value, Dimension dimension) {
  return of_a_machine(value, not_negative(value, dimension));
}

double not_negative_or(StrictTable& table, std::string_view key,
                       Dimension dimension, double otherwise) {
  const auto value = table.find(key);
  return value ? not_negative(*value, dimension) : otherwise;
}

LineUnits line_units(bool angle) {
  return angle ? LineUnits{Dimension::kAngle, Dimension::kAngularVelocity,
                           Dimension::kTorque, Dimension::kAngularStiffness,
                           Dimension::kAngularDamping}
               : LineUnits{Dimension::kLength, Dimension::kVelocity,
                           Dimension::kForce, Dimension::kStiffness,
                           Dimension::kDamping};
}

ForceElement read_element(ElementType type, const std::string& name,
                          StrictTable& table,
                          const std::vector<JointDefinition>& joints,
                          const Names& names) {
  ForceElement result;
  if (type == ElementType::kContact) {
    ContactElement contact = read_contact(table, names);
    contact.name = name;
    contact.place = table.place();
    result = contact;
  } else if (type == ElementType::kImpedance) {
    ImpedanceElement impedance = read_impedance(table, names);
    impedance.name = name;
    impedance.place = table.place();
    result = impedance;
  } else {
    LineElement element;
    element.name = name;
    element.place = table.place();
    element.line = read_line(table, joints, names,
                             type == ElementType::kSpring ||
                                     type == ElementType::kGasCylinder ||
                                     type == ElementType::kTable
                                 ? Needs::kAnyLine
                                 : Needs::kFixedAxis);
    const LineUnits units = line_units(is_angle(element.line, joints));
    if (type == ElementType::kSpring) element.law = read_spring(table, units);
    if (type == ElementType::kFriction) {
      element.law = read_friction(table, element.line, joints);
    }
    if (type == ElementType::kStop) element.law = read_stop(table, units);
    if (type == ElementType::kTable) element.law = read_table(table, units);
    if (type == ElementType::kSpring || type == ElementType::kTable) {
      read_sense(table, units, element);
    }
    if (type == ElementType::kGasCylinder) {
      element.law = read_gas_cylinder(table, is_angle(element.line, joints));
    }
    if (type == ElementType::kMotor) {
      element.law = read_motor(table, is_revolute(element.line, joints));
    }
    if (type == ElementType::kServo) {
      element.law = read_servo_on(table, element.line, joints);
    }
    result = element;
  }
  table.finish("with this type of force");
  return result;
}

}  // namespace clevis::scene
