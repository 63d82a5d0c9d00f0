#include "mechanism/forces/force_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/index.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/forces/element_modes.h"

namespace clevis::mechanism {
namespace {

void add_wrench(Twist& sum, const Twist& wrench) {
  sum.v += wrench.v;
  sum.w += wrench.w;
}

/// Coordinate of a joint at t = 0 where the scene says it, else 0: decides
/// from which turn an angle counts.
double start_of(const LineElement& element,
                const MechanismDefinition& definition) {
  const ElementLine& line = element.line;
  if (line.kind != ElementLine::Kind::kJoint) return 0.0;
  for (const DriveDefinition& drive : definition.drives) {
    if (drive.joint == line.joint && drive.coordinate == line.coordinate) {
      return drive_target(drive, 0.0).position;
    }
  }
  for (const InitialJointState& initial : definition.initial_joints) {
    if (initial.joint == line.joint && line.coordinate == 0) {
      return initial.position.value_or(0.0);
    }
  }
  const auto* servo = std::get_if<ServoLaw>(&element.law);
  return servo == nullptr ? 0.0 : drive_target(servo->reference, 0.0).position;
}

std::vector<GasChamberState> chambers_of(const ActingElement& e) {
  const GasCylinderLaw* gas = gas_law(*e.definition);
  if (gas == nullptr) return {};
  const auto count = static_cast<std::ptrdiff_t>(gas->chambers.size());
  return {e.gas.begin(), e.gas.begin() + count};
}

std::optional<MotorState> motor_of(const ActingElement& e) {
  if (motor_law(*e.definition) == nullptr) return std::nullopt;
  return e.motor;
}

std::optional<double> target_of(const ActingElement& e, double t) {
  const ServoLaw* servo = servo_law(*e.definition);
  if (servo == nullptr) return std::nullopt;
  return drive_target(servo->reference, t).position;
}

std::optional<GasInterface> interface_of(const ActingElement& e) {
  const GasCylinderLaw* gas = gas_law(*e.definition);
  if (gas == nullptr || !gas->is_coupled()) return std::nullopt;
  return e.interface;
}

/// Times at which the law of a drive or servo bends.
void add_kinks(const DriveDefinition& drive, std::vector<double>& times) {
  times.push_back(drive.start);
  times.push_back(drive.start + drive.duration);
  for (const double t : drive.table.times) times.push_back(drive.start + t);
}

}  // namespace

ForceModel::ForceModel(const MechanismDefinition& definition,
                       const SolvingFrame& frame)
    : definitions_(definition.elements) {
  for (const ForceElement& given : definitions_) {
    may_switch_ = may_switch_ || mechanism::may_switch(given);
    elements_.push_back(acting_element(given, frame, internal_states_));
    if (const auto* line = std::get_if<LineElement>(&given)) {
      elements_.back().q_start = start_of(*line, definition);
    }
  }
}

void ForceModel::start_internal(const Configuration& x, double* internal) {
  for (ActingElement& e : elements_) mechanism::start_internal(e, x, internal);
}

void ForceModel::evaluate(double t, const Configuration& x,
                          const std::vector<Twist>& twists,
                          const double* internal) {
  t_ = t;
  const numerics::StepSide side = t > piece_start_
                                      ? numerics::StepSide::kBefore
                                      : numerics::StepSide::kBehind;
  for (ActingElement& e : elements_) {
    mechanism::evaluate(e, t, x, twists, internal, side);
  }
}

double ForceModel::next_communication() const {
  double next = std::numeric_limits<double>::infinity();
  for (const ActingElement& e : elements_) {
    next = std::min(next, mechanism::next_communication(e));
  }
  return next;
}

void ForceModel::communicate(double t) {
  for (ActingElement& e : elements_) {
    if (mechanism::next_communication(e) <= t) mechanism::communicate(e, t);
  }
}

void ForceModel::accept(double t) {
  for (ActingElement& e : elements_) mechanism::accept(e, t);
}

void ForceModel::add_to(std::vector<Twist>& wrenches) const {
  for (const ActingElement& e : elements_) {
    add_wrench(wrenches[index(e.line.a)], e.on_a);
    add_wrench(wrenches[index(e.line.b)], e.on_b);
  }
}

void ForceModel::internal_rates(double* rates) const {
  for (const ActingElement& e : elements_) {
    std::copy_n(e.internal_rates.begin(), e.internal_count, rates);
    rates += e.internal_count;
  }
}

void ForceModel::internal_scales(const double* internal, double* scales) const {
  for (const ActingElement& e : elements_) {
    if (e.internal < 0) continue;
    if (const GasCylinderLaw* gas = gas_law(*e.definition)) {
      gas_scales(*gas, internal + e.internal, scales + e.internal);
      continue;
    }
    if (const MotorLaw* motor = motor_law(*e.definition)) {
      motor_scales(*motor, internal + e.internal, scales + e.internal);
      continue;
    }
    const FrictionLaw& law = *switched_friction(*e.definition);
    scales[e.internal] = law.breakaway / law.bristle_stiffness;
  }
}

void ForceModel::choose_modes() {
  for (ActingElement& e : elements_) mechanism::choose_modes(e);
}

bool ForceModel::sticks(std::size_t k) const {
  return mechanism::sticks(elements_[k]);
}

bool ForceModel::any_sticks() const {
  return std::ranges::any_of(elements_, mechanism::sticks);
}

void ForceModel::set_row_effort(std::size_t k, double effort) {
  ActingElement& e = elements_[k];
  const bool turns_rotor = inertia(k) > 0.0;
  act_along(e, turns_rotor ? e.effort + effort : effort);
  if (turns_rotor) e.power = e.effort * e.rate;
}

bool ForceModel::counts_turns() const {
  return std::ranges::any_of(elements_, [](const ActingElement& e) {
    return e.line.counts_turns;
  });
}

double ForceModel::line_bias(std::size_t k,
                             const std::vector<Twist>& twists) const {
  const ActingElement& e = elements_[k];
  return e.placed.bias(e.row, twists[index(e.line.a)], twists[index(e.line.b)]);
}

double ForceModel::joint_rate(std::size_t k,
                              const std::vector<PlacedJoint>& placed,
                              const std::vector<Twist>& twists) const {
  const ActingElement& e = elements_[k];
  const int joint = std::get<LineElement>(*e.definition).line.joint;
  const Eigen::Vector3d axis = placed[index(joint)].axes_a.col(2);
  return axis.dot(twists[index(e.line.b)].w - twists[index(e.line.a)].w);
}

double ForceModel::line_acceleration(std::size_t k,
                                     const std::vector<Twist>& accelerations,
                                     const std::vector<Twist>& twists) const {
  const ActingElement& e = elements_[k];
  const Twist& a = accelerations[index(e.line.a)];
  const Twist& b = accelerations[index(e.line.b)];
  return e.levers.a.v.dot(a.v) + e.levers.a.w.dot(a.w) + e.levers.b.v.dot(b.v) +
         e.levers.b.w.dot(b.w) + line_bias(k, twists);
}

double ForceModel::sliding_acceleration(
    std::size_t k, const std::vector<Twist>& accelerations) const {
  const ActingElement& e = elements_[k];
  const Twist& a = accelerations[index(e.line.a)];
  const Twist& b = accelerations[index(e.line.b)];
  const Eigen::Vector3d n = e.placed.axes_a.col(2);
  const double radius = std::get<ContactElement>(*e.definition).radius;
  const Eigen::Vector3d on_b = e.placed.r_b - radius * n;
  const Eigen::Vector3d on_a = e.placed.r_a + e.placed.d - radius * n;
  const Eigen::Vector3d sum = b.v + b.w.cross(on_b) - a.v - a.w.cross(on_a);
  return (sum - n.dot(sum) * n).norm();
}

bool ForceModel::is_dry(std::size_t k) const {
  const FrictionLaw* law = switched_friction(*elements_[k].definition);
  return law != nullptr && law->model == FrictionModel::kCoulomb;
}

double ForceModel::breakaway(std::size_t k) const {
  return elements_[k].load *
         switched_friction(*elements_[k].definition)->breakaway;
}

std::vector<std::size_t> ForceModel::with_smooth_efforts() const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const auto* line = std::get_if<LineElement>(elements_[k].definition);
    if (line == nullptr || line->acts_on != ActsOn::kBoth) continue;
    const bool smooth = std::holds_alternative<SpringLaw>(line->law) ||
                        std::holds_alternative<StopLaw>(line->law) ||
                        std::holds_alternative<ServoLaw>(line->law) ||
                        std::holds_alternative<GasCylinderLaw>(line->law);
    if (smooth) found.push_back(k);
  }
  return found;
}

void ForceModel::set_effort(std::size_t k, double effort) {
  ActingElement& e = elements_[k];
  act_along(e, effort);
  e.power = e.effort * e.rate;
}

void ForceModel::set_load(std::size_t k, double load) {
  ActingElement& e = elements_[k];
  e.load = load;
  if (sticks(k)) return;
  act_along(e, load * e.per_load + e.own_effort);
  e.power = e.effort * e.rate;
}

std::size_t ForceModel::line_against_its_mode() const {
  constexpr double kTimesSlack = 10.0;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const ActingElement& e = elements_[k];
    if (!is_dry(k)) continue;
    const int mode = e.modes[0];
    if (mode == kLetGo || std::abs(mode) == 2) continue;  // an event ends it
    const double against = mode == 0 ? std::abs(e.rate) : -mode * e.rate;
    if (against > kTimesSlack * e.slack) return k;
  }
  return elements_.size();
}

void ForceModel::hold_tangents(const double* internal) {
  for (ActingElement& e : elements_) hold_tangent(e, internal);
}

void ForceModel::release_tangents() {
  for (ActingElement& e : elements_) e.tangent.holds = false;
}

void ForceModel::set_slack(double slack, double leaving, double length,
                           double per_second) {
  for (ActingElement& e : elements_) {
    const double arm = e.row.is_angle() ? length : 1.0;
    e.slack = slack / arm;
    e.leaving = leaving / arm;
    const FrictionLaw* law = switched_friction(*e.definition);
    if (law == nullptr || law->model != FrictionModel::kLuGre) continue;
    const double deflection = law->breakaway / law->bristle_stiffness;
    e.slack = std::min(e.slack, per_second * deflection);
  }
}

void ForceModel::event_values(Eigen::VectorXd& values) const {
  for (int i = 0; i < events(); ++i) {
    values[i] = event_value(elements_[index(i / 2)], i % 2);
  }
}

void ForceModel::pass_event(int event) {
  mechanism::pass_event(elements_[index(event / 2)], event % 2);
}

std::vector<int> ForceModel::modes() const {
  std::vector<int> modes;
  for (const ActingElement& e : elements_) {
    modes.insert(modes.end(), e.modes.begin(), e.modes.end());
  }
  return modes;
}

std::vector<MotionEvent> ForceModel::changes(
    int event, double t, const std::vector<int>& before) const {
  std::vector<MotionEvent> changes;
  for (int i = 0; i < events(); ++i) {
    const auto k = index(i / 2);
    if (i != event && !is_dry(k)) continue;
    const char* what = name_of_change(elements_[k], i % 2, before[index(i)]);
    if (what != nullptr) changes.push_back({t, i / 2, what});
  }
  return changes;
}

std::vector<double> ForceModel::kink_times() const {
  std::vector<double> times;
  const auto add = [&times](const std::vector<double>& more) {
    times.insert(times.end(), more.begin(), more.end());
  };
  for (const ForceElement& element : definitions_) {
    if (const auto* line = std::get_if<LineElement>(&element)) {
      const auto* table = std::get_if<TableLaw>(&line->law);
      if (table != nullptr) add(table->times);
      const MotorLaw* motor = motor_law(element);
      if (motor != nullptr) add(motor->times);
      const ServoLaw* servo = servo_law(element);
      if (servo != nullptr) add_kinks(servo->reference, times);
      const GasCylinderLaw* gas = gas_law(element);
      for (std::size_t k = 0; gas != nullptr && k < gas->chambers.size(); ++k) {
        if (gas->chambers[k].valve) add(gas->chambers[k].valve->times);
      }
    } else if (const auto* i = std::get_if<ImpedanceElement>(&element)) {
      add(i->path_W[0].times);
    }
  }
  return times;
}

std::vector<ElementState> ForceModel::states() const {
  std::vector<ElementState> states;
  for (const ActingElement& e : elements_) {
    states.push_back({.position = e.q,
                      .rate = e.rate,
                      .effort = e.effort,
                      .friction = e.friction,
                      .power = e.power,
                      .chambers = chambers_of(e),
                      .actions = actions(e),
                      .motor = motor_of(e),
                      .target = target_of(e, t_),
                      .interface = interface_of(e)});
  }
  return states;
}

}  // namespace clevis::mechanism
