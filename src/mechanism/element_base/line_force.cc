#include "mechanism/element_base/line_force.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/values/index.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {
namespace {

// Points at a distance of zero push along no direction.
constexpr double kShortest = 1e-12;  // [m]

double sense_of(ActsOn acts_on) {
  return acts_on == ActsOn::kBoth         ? 0.0
         : acts_on == ActsOn::kIncreasing ? 1.0
                                          : -1.0;
}

}  // namespace

LineForce::LineForce(const LineDefinition& definition,
                     const ReferenceFrame& frame) {
  const ElementLine& measured = definition.line;
  R_PW = frame.R_WP.transpose();
  if (measured.kind == ElementLine::Kind::kJoint) {
    joint = measured.joint;
    line = frame.joints[index(joint)];
    row = coordinate_row(line.type, measured.coordinate);
    line.counts_turns = row.is_angle();
    return;
  }
  join(measured.a, measured.b, frame);
  if (measured.kind == ElementLine::Kind::kDistance) {
    line.type = JointType::kDistance;
    row = {JointRow::Kind::kDistance, 0};
    return;
  }
  line.type = JointType::kPrismatic;
  row = {JointRow::Kind::kTranslation, 2};
  line.frame_a.R_LJ = line.frame_a.R_LJ * with_z_along(measured.axis_L);
}

void LineForce::measure(ElementResponse& now) const {
  PlacedJoint& placed = now.placed;
  const bool is_distance = row.kind == JointRow::Kind::kDistance;
  // the row then measures the distance itself
  if (is_distance) placed.length = std::max(placed.d.norm(), kShortest);
  now.levers = placed.levers(row);
  now.q = is_distance ? placed.length : placed.displacement(row);
  if (!row.is_second_angle()) return;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  now.q += kTurn * std::round((placed.angle_near - now.q) / kTurn);
}

ElementSpring LineForce::spring(const Configuration& x,
                                const ElementState& state) const {
  const LineTangent along = tangent(state);
  if (along.is_zero()) return {};
  PlacedJoint placed = placed_in(x);
  if (row.kind == JointRow::Kind::kDistance) {
    placed.length = std::max(placed.d.norm(), kShortest);
  }
  return {.directions = {placed.levers(row)},
          .stiffness = Eigen::MatrixXd::Constant(1, 1, along.stiffness),
          .damping = Eigen::MatrixXd::Constant(1, 1, along.damping),
          .relaxes = along.relaxes};
}

void LineForce::act(const ActingState& state, const Twist& a, const Twist& b,
                    ElementResponse& now) const {
  measure(now);
  const PlacedJoint::Levers& levers = now.levers;
  now.rate = levers.a.v.dot(a.v) + levers.a.w.dot(a.w) + levers.b.v.dot(b.v) +
             levers.b.w.dot(b.w);
  now.act_along(law_effort(state, now));
}

OneSenseForce::OneSenseForce(const LineDefinition& definition,
                             const ReferenceFrame& frame)
    : LineForce(definition, frame),
      acts_on_(definition.acts_on),
      full_speed_(definition.full_speed),
      sharp_sense_(full_speed_ > 0.0 ? 0.0 : sense_of(acts_on_)) {}

double OneSenseForce::law_effort(const ActingState& state,
                                 ElementResponse& now) const {
  return part_in_sense(now.rate) * full_effort(state, now);
}

double OneSenseForce::part_in_sense(double rate) const {
  if (acts_in_both()) return 1.0;
  if (full_speed_ <= 0.0) return modes[1] == 1 ? 1.0 : 0.0;
  const double s =
      std::clamp(sense_of(acts_on_) * rate / full_speed_, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

void OneSenseForce::choose_modes(const ElementResponse& now) {
  if (sharp_sense_ != 0.0) modes[1] = sharp_sense_ * now.rate > 0.0 ? 1 : 0;
}

double OneSenseForce::event_value(int end, const ElementResponse& now) const {
  if (sharp_sense_ == 0.0 || end == 0) return 1.0;
  const double forward = modes[1] == 1 ? sharp_sense_ : -sharp_sense_;
  return forward * now.rate + kOfTolerance * velocity_tolerance;
}

void OneSenseForce::pass_event(int end, const ElementResponse& /*now*/) {
  if (end == 1 && sharp_sense_ != 0.0) modes[1] = 1 - modes[1];
}

const char* OneSenseForce::name_of_change(int end, int mode_before) const {
  if (sharp_sense_ == 0.0 || end == 0 || modes[1] == mode_before) {
    return nullptr;
  }
  return modes[1] == 1 ? "act" : "rest";
}

std::vector<ElementGuard> OneSenseForce::guards() const {
  using enum ElementGuard::Kind;
  if (acts_in_both()) return {};
  std::vector<ElementGuard> all{{kRate, 0, 0.0}};
  if (full_speed_ > 0.0) {
    all.push_back({kRate, 0, sense_of(acts_on_) * full_speed_});
  }
  return all;
}

}  // namespace clevis::mechanism
