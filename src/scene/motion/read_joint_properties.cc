#include "scene/motion/read_joint_properties.h"

#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "mechanism/definition/meshing_wheels.h"
#include "mechanism/joints/joint_types.h"
#include "scene/text/names.h"
#include "scene/text/suggestion.h"

namespace clevis::scene {
namespace {

using Eigen::Vector3d;
using mechanism::BodyDefinition;
using mechanism::BodyIndex;
using mechanism::CouplingDefinition;
using mechanism::JointCompliance;
using mechanism::JointDefinition;
using mechanism::JointType;

Vector3d world_point(const std::vector<BodyDefinition>& bodies, BodyIndex body,
                     const Vector3d& p_LP) {
  if (body == mechanism::kGround) return p_LP;
  const auto& X = bodies[static_cast<std::size_t>(body)].placement;
  return X.p_WL + X.R_WL * p_LP;
}

double read_length(StrictTable& table,
                   const std::vector<BodyDefinition>& bodies,
                   const JointDefinition& joint) {
  if (const auto length = table.find("length")) {
    return length->positive(Dimension::kLength);
  }
  const double placed = (world_point(bodies, joint.body_a, joint.frame_a.p_LJ) -
                         world_point(bodies, joint.body_b, joint.frame_b.p_LJ))
                            .norm();
  if (placed > 0.0) return placed;
  throw table.refusal("S003", "lacks the key \"length\"",
                      "Its points coincide in the reference placement: give "
                      "the length of the rod.");
}

Vector3d read_compliances(const Value& value, Dimension dimension) {
  const Vector3d result = value.vector(dimension);
  if ((result.array() > 0.0).all()) return result;
  throw value.refusal("S006", "is not positive in all three directions",
                      "Give three values above 0; a small one is stiff.");
}

JointCompliance read_compliance(StrictTable table) {
  JointCompliance compliance;
  compliance.force = read_compliances(table["force"], Dimension::kCompliance);
  compliance.moment =
      read_compliances(table["moment"], Dimension::kAngularCompliance);
  return compliance;
}

/// The coordinate that the user names, or the first that is (not) an angle.
int coupled_coordinate(const JointDefinition& joint, const Value& where,
                       const std::optional<Value>& name, bool angle) {
  const auto all = mechanism::coordinates(joint.type);
  if (name) {
    const int found = find_coordinate(*name, joint);
    if (all[static_cast<std::size_t>(found)].row.is_angle() == angle) {
      return found;
    }
    throw name->refusal("S010", angle ? "is no angle" : "is no distance",
                        "A gear couples two angles, a rack a distance with "
                        "an angle.");
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].row.is_angle() == angle) return static_cast<int>(k);
  }
  throw where.refusal(
      "S010",
      fmt::format("= \"{}\" is a {} joint and has no {}", joint.name,
                  name_of(joint.type), angle ? "angle" : "distance"),
      "A gear couples two angles, a rack a distance with an angle.");
}

double read_tooth_angle(const Value& value, double low, double high) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const double angle = value.quantity(Dimension::kAngle);
  if (low * kDegree <= angle && angle <= high * kDegree) return angle;
  throw value.refusal(
      "S006", "is out of range",
      fmt::format("Give an angle from {} to {} deg.", low, high));
}

/// The keys that resolve the tooth force of a coupling that is read but for
/// them.
void read_teeth(StrictTable& table, bool is_gear,
                const std::vector<JointDefinition>& joints,
                CouplingDefinition& coupling) {
  const auto pressure_angle = table.find("pressure_angle");
  const auto helix_angle = table.find("helix_angle");
  const auto mid_face = table.find("mid_face");
  if (!pressure_angle) {
    for (const auto& key : {helix_angle, mid_face}) {
      if (!key) continue;
      throw key->refusal("S010", "stands without `pressure_angle`",
                         "Give the teeth's `pressure_angle`, as \"20 deg\".");
    }
    return;
  }
  if (helix_angle && !is_gear) {
    throw helix_angle->refusal("S010", "stands in a rack",
                               "Only racks with straight teeth are resolved.");
  }
  mechanism::ToothGeometry& teeth = coupling.teeth.emplace();
  teeth.pressure_angle = read_tooth_angle(*pressure_angle, 0.0, 45.0);
  if (helix_angle) {
    teeth.helix_angle = read_tooth_angle(*helix_angle, -60.0, 60.0);
  }
  if (mid_face) teeth.mid_face = mid_face->quantity(Dimension::kLength);
  if (const auto misfit = mechanism::tooth_misfit(joints, coupling)) {
    throw pressure_angle->refusal("S010", misfit->what, misfit->remedy);
  }
}

CouplingDefinition read_coupling(StrictTable& table,
                                 const std::vector<JointDefinition>& joints,
                                 Names& names) {
  CouplingDefinition coupling;
  const Value name = table["name"];
  coupling.name = name.name();
  coupling.place = table.place();
  names.couplings.add(coupling.name, name);
  enum class Type { kGear, kRack };
  const Value type = table["type"];
  const Type kind =
      type.choice<Type>({{"gear", Type::kGear}, {"rack", Type::kRack}});
  const auto two = table["joints"].elements(2);
  coupling.joint_1 = names.joints.find(two[0].name(), two[0]);
  coupling.joint_2 = names.joints.find(two[1].name(), two[1]);
  std::vector<std::optional<Value>> chosen(2);
  if (const auto given = table.find("coordinates")) {
    const auto elements = given->elements(2);
    chosen = {elements[0], elements[1]};
  }
  const bool gear = kind == Type::kGear;
  const auto joint = [&joints](int index) {
    return joints[static_cast<std::size_t>(index)];
  };
  coupling.coordinate_1 =
      coupled_coordinate(joint(coupling.joint_1), two[0], chosen[0], gear);
  coupling.coordinate_2 =
      coupled_coordinate(joint(coupling.joint_2), two[1], chosen[1], true);
  if (coupling.joint_1 == coupling.joint_2 &&
      coupling.coordinate_1 == coupling.coordinate_2) {
    throw two[1].refusal("S010", "couples a coordinate with itself",
                         "Name two different joints or coordinates.");
  }
  const Value ratio = table[gear ? "ratio" : "radius"];
  coupling.ratio =
      gear ? ratio.number(-1e6, 1e6) : ratio.quantity(Dimension::kLength);
  if (coupling.ratio == 0.0) {
    throw ratio.refusal("S006", "is zero",
                        gear ? "Give a ratio of either sign."
                             : "Give the pinion's radius, of either sign.");
  }
  if (const auto offset = table.find("offset")) {
    coupling.offset =
        offset->quantity(gear ? Dimension::kAngle : Dimension::kLength);
  }
  read_teeth(table, gear, joints, coupling);
  table.finish(fmt::format("with type = \"{}\"", type.text()));
  return coupling;
}

}  // namespace

void read_joint_properties(StrictTable& table,
                           const std::vector<BodyDefinition>& bodies,
                           JointDefinition& joint) {
  using Parameter = mechanism::JointTraits::Parameter;
  const Parameter parameter = mechanism::traits(joint.type).parameter;
  if (parameter == Parameter::kLead) {
    const Value lead = table["lead"];
    joint.lead = lead.quantity(Dimension::kLength);
    if (joint.lead == 0.0) {
      throw lead.refusal("S006", "is zero",
                         "Give the slide per turn, negative for a left-handed "
                         "thread, or use a revolute joint.");
    }
  }
  if (parameter == Parameter::kLength) {
    joint.length = read_length(table, bodies, joint);
  }
  if (table.has("compliance")) {
    joint.compliance = read_compliance(table.table("compliance"));
  }
}

int find_coordinate(const Value& value, const JointDefinition& joint) {
  const std::string name = value.text();
  const auto all = mechanism::coordinates(joint.type);
  std::vector<std::string_view> known;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].name == name) return static_cast<int>(k);
    known.push_back(all[k].name);
  }
  throw value.refusal("S009",
                      fmt::format("= \"{}\" is no coordinate of a {} joint",
                                  name, name_of(joint.type)),
                      suggestion(name, known));
}

std::vector<CouplingDefinition> read_couplings(
    StrictTable& root, const std::vector<JointDefinition>& joints,
    Names& names) {
  std::vector<CouplingDefinition> couplings;
  for (StrictTable& table : root.tables("coupling")) {
    couplings.push_back(read_coupling(table, joints, names));
  }
  return couplings;
}

}  // namespace clevis::scene
