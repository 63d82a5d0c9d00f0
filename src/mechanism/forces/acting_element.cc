#include "mechanism/forces/acting_element.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "base/index.h"
#include "mechanism/force_laws/force_laws.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Points at a distance of zero push along no direction.
constexpr double kShortest = 1e-12;  // [m]

Matrix3d with_z_along(const Vector3d& z) {
  return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), z)
      .toRotationMatrix();
}

JointFrame frame_of(const ElementPoint& p, const SolvingFrame& frame) {
  JointFrame result;
  if (p.body == kGround) {
    result.p_LJ = frame.R_WP.transpose() * p.p_L;
    result.R_LJ = frame.R_WP.transpose();
  } else {
    result.p_LJ = p.p_L - frame.p_LM[index(p.body)];
  }
  return result;
}

void join(ActingElement& e, const ElementPoint& a, const ElementPoint& b,
          const SolvingFrame& frame) {
  e.line.a = a.body + 1;
  e.line.b = b.body + 1;
  e.line.frame_a = frame_of(a, frame);
  e.line.frame_b = frame_of(b, frame);
}

void join_line(ActingElement& e, const ElementLine& line,
               const SolvingFrame& frame) {
  if (line.kind == ElementLine::Kind::kJoint) {
    e.line = frame.joints[index(line.joint)];
    e.row = coordinate_row(e.line.type, line.coordinate);
    e.line.counts_turns = e.row.is_angle();
    return;
  }
  join(e, line.a, line.b, frame);
  if (line.kind == ElementLine::Kind::kDistance) {
    e.line.type = JointType::kDistance;
    e.row = {JointRow::Kind::kDistance, 0};
    return;
  }
  e.line.type = JointType::kPrismatic;
  e.row = {JointRow::Kind::kTranslation, 2};
  e.line.frame_a.R_LJ =
      e.line.frame_a.R_LJ * with_z_along(line.axis_L.normalized());
}

double unilateral(ActingElement& e, std::size_t end, const ContactLaw& law,
                  double depth, double rate) {
  e.depth[end] = depth;
  e.depth_rate[end] = rate;
  e.unbounded[end] = contact_effort(law, depth, rate);
  return e.modes[end] == 1 ? e.unbounded[end] : 0.0;
}

double line_friction(ActingElement& e, const FrictionLaw& law,
                     const double* internal) {
  const double bristle = e.internal_count > 0 ? internal[e.internal] : 0.0;
  const ActingElement::Tangent& at = e.tangent;
  const FrictionEffort f =
      at.holds ? friction_along_tangent(law, at.line, e.rate - at.rate,
                                        bristle - at.bristle)
               : friction_effort(law, e.modes[0], e.rate, bristle, e.slack);
  e.internal_rates[0] = f.bristle_rate;
  e.load = law.follows_reaction ? 0.0 : 1.0;
  e.per_load = f.per_load;
  e.own_effort = f.own;
  return e.load * f.per_load + f.own;
}

/// The part of an effort that acts on one sense of motion alone.
double part_in_sense(const ActingElement& e, const LineElement& element) {
  if (element.acts_on == ActsOn::kBoth) return 1.0;
  if (element.full_speed <= 0.0) return e.modes[1] == 1 ? 1.0 : 0.0;
  const double speed =
      element.acts_on == ActsOn::kIncreasing ? e.rate : -e.rate;
  const double s = std::clamp(speed / element.full_speed, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

double law_effort(ActingElement& e, const LineElement& element, double t,
                  const double* internal, numerics::StepSide side) {
  if (const auto* spring = std::get_if<SpringLaw>(&element.law)) {
    return -spring->stiffness * (e.q - spring->free) -
           spring->damping * e.rate - spring->preload;
  }
  if (const auto* table = std::get_if<TableLaw>(&element.law)) {
    return table->positions.empty()
               ? numerics::linear_at(table->times, table->efforts, t, side)
               : piece_effort(*table, e.modes[0], e.q);
  }
  if (const auto* gas = std::get_if<GasCylinderLaw>(&element.law)) {
    const double* own = internal + e.internal;
    return gas->is_coupled()
               ? coupled_gas_effort(*gas, t, e.rate, own, e.internal_rates,
                                    e.gas, e.interface)
               : gas_effort(*gas, t, e.q, e.rate, own, e.internal_rates, e.gas);
  }
  if (const auto* motor = std::get_if<MotorLaw>(&element.law)) {
    return motor_effort(*motor, t, e.rate, internal + e.internal,
                        e.internal_rates.data(), e.motor);
  }
  if (const auto* servo = std::get_if<ServoLaw>(&element.law)) {
    return servo_effort(*servo, t, e.q, e.rate);
  }
  if (const auto* stop = std::get_if<StopLaw>(&element.law)) {
    double effort = 0.0;
    if (stop->lower) {
      effort += unilateral(e, 0, stop->contact, *stop->lower - e.q, -e.rate);
    }
    if (stop->upper) {
      effort -= unilateral(e, 1, stop->contact, e.q - *stop->upper, e.rate);
    }
    return effort;
  }
  return line_friction(e, std::get<FrictionLaw>(element.law), internal);
}

/// Of a universal joint; a placed joint counts the turns of its first alone.
bool is_second_angle(const JointRow& row) {
  return row.kind == JointRow::Kind::kUniversal && row.axis == 1;
}

void measure_line(ActingElement& e) {
  const bool is_distance = e.row.kind == JointRow::Kind::kDistance;
  // the row then measures the distance itself
  if (is_distance) e.placed.length = std::max(e.placed.d.norm(), kShortest);
  e.levers = e.placed.levers(e.row);
  e.q = is_distance ? e.placed.length : e.placed.displacement(e.row);
  if (!is_second_angle(e.row)) return;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  e.q += kTurn * std::round((e.placed.angle_near - e.q) / kTurn);
}

void evaluate_line(ActingElement& e, const LineElement& element, double t,
                   const Twist& a, const Twist& b, const double* internal,
                   numerics::StepSide side) {
  measure_line(e);
  e.rate = e.levers.a.v.dot(a.v) + e.levers.a.w.dot(a.w) +
           e.levers.b.v.dot(b.v) + e.levers.b.w.dot(b.w);
  act_along(
      e, part_in_sense(e, element) * law_effort(e, element, t, internal, side));
}

void evaluate_contact(ActingElement& e, const ContactElement& contact,
                      const Twist& a, const Twist& b) {
  const Vector3d n = e.placed.axes_a.col(2);
  // levers of the contact point on both bodies
  const Vector3d on_b = e.placed.r_b - contact.radius * n;
  const Vector3d on_a = e.placed.r_a + e.placed.d - contact.radius * n;
  const Vector3d v = b.v + b.w.cross(on_b) - a.v - a.w.cross(on_a);
  e.q = contact.radius - n.dot(e.placed.d);
  e.rate = -n.dot(v);
  e.effort = unilateral(e, 0, contact.law, e.q, e.rate);
  e.sliding = v + e.rate * n;
  Vector3d f = e.effort * n;
  e.friction = 0.0;
  if (e.effort > 0.0) {
    const ActingElement::Tangent& at = e.tangent;
    const Vector3d coefficient =
        at.holds ? Vector3d(at.contact.coefficient +
                            at.contact.slope * (e.sliding - at.sliding))
                 : sliding_friction(contact, e.sliding, e.slack).coefficient;
    e.friction = coefficient.norm() * e.effort;
    f -= e.effort * coefficient;
  }
  e.on_b = {f, on_b.cross(f)};
  e.on_a = {-f, on_a.cross(Vector3d(-f))};
}

void evaluate_impedance(ActingElement& e, const ImpedanceElement& impedance,
                        double t, const Twist& b) {
  Vector3d target = impedance.target_W, target_rate = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const numerics::CubicSpline& path = impedance.path_W[index(k)];
    if (path.times.empty()) continue;
    const numerics::CubicSpline::Point at = path.at(t);
    target[k] = at.value;
    if (!impedance.damps_absolute) target_rate[k] = at.rate;
  }
  const Vector3d off = e.placed.p_b - e.R_PW * target;
  const Vector3d rate = b.v + b.w.cross(e.placed.r_b) - e.R_PW * target_rate;
  const Vector3d f = -impedance.stiffness * off - impedance.damping * rate;
  e.q = off.norm();
  e.rate = rate.norm();
  e.effort = f.norm();
  e.on_b = {f, e.placed.r_b.cross(f)};
}

/// Angle of a line by the mean of its rates since turns are counted.
double angle_near(const ActingElement& e, double t, const Configuration& x,
                  const Vector3d& turning) {
  const Vector3d axis =
      is_second_angle(e.row)
          ? Vector3d(x[index(e.line.b)].R * e.line.frame_b.R_LJ.col(0))
          : Vector3d(x[index(e.line.a)].R * e.line.frame_a.R_LJ.col(2));
  return e.q_start + 0.5 * (e.rate_start + axis.dot(turning)) * (t - e.t_start);
}

const JointModel kNothing{.frame_a = {}, .frame_b = {}};
const BodyPlacement kNowhere;

}  // namespace

ActingElement acting_element(const ForceElement& definition,
                             const SolvingFrame& frame, int& internal_states) {
  ActingElement e{.definition = &definition,
                  .line = {},
                  .row = {},
                  .R_PW = frame.R_WP.transpose(),
                  .placed = PlacedJoint(kNothing, kNowhere, kNowhere),
                  .levers = {}};
  if (const auto* line = std::get_if<LineElement>(&definition)) {
    join_line(e, line->line, frame);
    if (const FrictionLaw* friction = switched_friction(definition)) {
      e.modes[0] = 1;  // free, until modes are chosen
      if (friction->model == FrictionModel::kLuGre) {
        e.internal_count = 1;
      }
    } else if (const GasCylinderLaw* gas = gas_law(definition)) {
      e.internal_count = gas->internal_states();
    } else if (motor_law(definition) != nullptr) {
      e.internal_count = MotorLaw::kStates;
    }
    if (e.internal_count > 0) e.internal = internal_states;
    internal_states += e.internal_count;
  } else if (const auto* contact = std::get_if<ContactElement>(&definition)) {
    join(e, contact->plane, contact->center, frame);
    e.line.frame_a.R_LJ =
        e.line.frame_a.R_LJ * with_z_along(contact->normal_L.normalized());
  } else {
    join(e, {.body = kGround}, std::get<ImpedanceElement>(definition).point,
         frame);
  }
  return e;
}

void start_internal(ActingElement& e, const Configuration& x,
                    double* internal) {
  const GasCylinderLaw* gas = gas_law(*e.definition);
  if (gas == nullptr) return;
  e.placed = PlacedJoint(e.line, x[index(e.line.a)], x[index(e.line.b)]);
  measure_line(e);
  start_gas(*gas, name_of(*e.definition),
            std::get<LineElement>(*e.definition).place, e.q,
            internal + e.internal);
  e.interface = {.since = -gas->step, .q = e.q};  // due at t = 0
}

double next_communication(const ActingElement& e) {
  const GasCylinderLaw* gas = gas_law(*e.definition);
  return gas != nullptr && gas->is_coupled()
             ? e.interface.since + gas->step
             : std::numeric_limits<double>::infinity();
}

void communicate(ActingElement& e, double t) {
  const GasCylinderLaw* gas = gas_law(*e.definition);
  if (gas == nullptr || !gas->is_coupled()) return;
  communicate(e.interface, t, e.rate);
}

void evaluate(ActingElement& e, double t, const Configuration& x,
              const std::vector<Twist>& twists, const double* internal,
              numerics::StepSide side) {
  const Twist& a = twists[index(e.line.a)];
  const Twist& b = twists[index(e.line.b)];
  const double near =
      e.line.counts_turns ? angle_near(e, t, x, b.w - a.w) : 0.0;
  e.placed = PlacedJoint(e.line, x[index(e.line.a)], x[index(e.line.b)], near);
  if (const auto* line = std::get_if<LineElement>(e.definition)) {
    evaluate_line(e, *line, t, a, b, internal, side);
  } else if (const auto* c = std::get_if<ContactElement>(e.definition)) {
    evaluate_contact(e, *c, a, b);
  } else {
    evaluate_impedance(e, std::get<ImpedanceElement>(*e.definition), t, b);
  }
  e.power = e.on_a.v.dot(a.v) + e.on_a.w.dot(a.w) + e.on_b.v.dot(b.v) +
            e.on_b.w.dot(b.w);
}

void accept(ActingElement& e, double t) {
  if (!e.line.counts_turns) return;
  e.q_start = e.q;
  e.rate_start = e.rate;
  e.t_start = t;
}

std::array<ElementAction, 2> actions(const ActingElement& e) {
  Vector3d to_a = Vector3d::Zero(), to_b = Vector3d::Zero();  // from the J
  if (const auto* contact = std::get_if<ContactElement>(e.definition)) {
    to_b = -contact->radius * e.placed.axes_a.col(2);
    to_a = e.placed.d + to_b;
  }
  const Eigen::Matrix3d R_WP = e.R_PW.transpose();
  const auto action = [&R_WP](int slot, const Vector3d& p_J, const Vector3d& r,
                              const Vector3d& to, const Twist& wrench) {
    const Vector3d about_p = wrench.w - (r + to).cross(wrench.v);
    return ElementAction{.body = slot - 1,
                         .p_W = R_WP * (p_J + to),
                         .f_W = R_WP * wrench.v,
                         .t_W = R_WP * about_p};
  };
  return {
      action(e.line.a, e.placed.p_b - e.placed.d, e.placed.r_a, to_a, e.on_a),
      action(e.line.b, e.placed.p_b, e.placed.r_b, to_b, e.on_b)};
}

void hold_tangent(ActingElement& e, const double* internal) {
  ActingElement::Tangent& at = e.tangent;
  if (const auto* contact = std::get_if<ContactElement>(e.definition)) {
    at.sliding = e.sliding;
    at.contact = sliding_friction(*contact, e.sliding, e.slack);
    at.holds = true;
    return;
  }
  const auto* line = std::get_if<LineElement>(e.definition);
  const auto* law = line ? std::get_if<FrictionLaw>(&line->law) : nullptr;
  if (law == nullptr) return;
  at.rate = e.rate;
  at.bristle = e.internal_count > 0 ? internal[e.internal] : 0.0;
  at.line = friction_effort(*law, e.modes[0], at.rate, at.bristle, e.slack);
  at.holds = true;
}

void act_along(ActingElement& e, double effort) {
  e.effort = effort;
  e.on_a = {effort * e.levers.a.v, effort * e.levers.a.w};
  e.on_b = {effort * e.levers.b.v, effort * e.levers.b.w};
}

double line_inertia(const ActingElement& e) {
  const MotorLaw* motor = motor_law(*e.definition);
  return motor == nullptr ? 0.0 : motor->inertia_at_joint();
}

}  // namespace clevis::mechanism
