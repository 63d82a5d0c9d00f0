#include "machine/transmissions/module_error.h"

#include <algorithm>
#include <cmath>

namespace clevis::machine {
namespace {

/// Time stepping of both masses: velocities by the forces at the start of a
/// step, dry friction as the impulse that at most stops the load (Moreau),
/// then positions. Sliding at a constant speed is met exactly.
class TwoMassRun {
 public:
  explicit TwoMassRun(const ReversalModel& model)
      : model_(model), k_(1.0 / model.compliance) {
    const double slow = std::sqrt(k_ / model.load_inertia);
    const double fast =
        std::sqrt(k_ * (1.0 / model.load_inertia + 1.0 / model.motor_inertia));
    constexpr double kDampingRatio = 0.5, kStepsPerRadian = 100.0;
    // damps the load against the motor, and the motor's servo
    c_ = 2.0 * kDampingRatio * k_ / fast;
    servo_k_ = k_ + model.motor_inertia * fast * fast;
    servo_c_ = 2.0 * std::sqrt(servo_k_ * model.motor_inertia);
    const double servo = std::sqrt(servo_k_ / model.motor_inertia);
    h_ = 1.0 / (kStepsPerRadian * std::max(fast, servo));
    time_ = 1.0 / slow;
    speed_ = 0.05 * (model.backlash + 2.0 * model.friction * model.compliance) /
             time_;
    // The damping of the slow motion is c_ / (2 sqrt(k J)) = slow / fast of
    // its ratio.
    decay_ = time_ / (kDampingRatio * slow / fast);
  }

  /// Moves the servo's target with a sign until all has died away.
  /// @return how far the motor is ahead of the load.
  double pass(double sign) {
    const auto count = static_cast<long>(steps());
    for (long i = 0; i < count; ++i) step(sign * speed_);
    return motor_ - load_;
  }

  /// Of a pass.
  double steps() const {
    constexpr double kDecays = 30.0, kDeadTimes = 40.0;
    return (kDeadTimes * time_ + kDecays * decay_) / h_;
  }

 private:
  double coupling() const {
    const double ahead = motor_ - load_;
    const double half = 0.5 * model_.backlash;
    const double depth = std::abs(ahead) - half;
    if (depth <= 0.0) return 0.0;
    const double side = ahead > 0.0 ? 1.0 : -1.0;
    const double force = k_ * depth + c_ * side * (motor_rate_ - load_rate_);
    return side * std::max(0.0, force);  // flanks do not pull
  }

  void step(double target_rate) {
    const double force = coupling();
    const double servo =
        servo_k_ * (target_ - motor_) + servo_c_ * (target_rate - motor_rate_);
    motor_rate_ += h_ * (servo - force) / model_.motor_inertia;
    const double free = load_rate_ + h_ * force / model_.load_inertia;
    const double most = h_ * model_.friction / model_.load_inertia;
    load_rate_ = std::copysign(std::max(0.0, std::abs(free) - most), free);
    target_ += h_ * target_rate;
    motor_ += h_ * motor_rate_;
    load_ += h_ * load_rate_;
  }

  const ReversalModel& model_;
  double k_, c_{}, servo_k_{}, servo_c_{};
  double h_{}, time_{}, speed_{}, decay_{};
  double target_{}, motor_{}, load_{}, motor_rate_{}, load_rate_{};
};

}  // namespace

ModuleError module_error(const ErrorShares& shares, double load,
                         double compliance) {
  ModuleError error;
  error.shares = shares;
  error.compliance = std::abs(load) * compliance;
  error.worst =
      shares.control + shares.kinematic + shares.backlash + error.compliance;
  error.rss = std::hypot(std::hypot(shares.control, shares.kinematic),
                         std::hypot(shares.backlash, error.compliance));
  error.reversal = shares.backlash + 2.0 * shares.friction * compliance;
  return error;
}

std::optional<double> run_reversal(const ReversalModel& model) {
  constexpr double kMostSteps = 5e7;
  TwoMassRun run(model);
  if (!(run.steps() < kMostSteps)) return std::nullopt;
  const double forward = run.pass(1.0);
  return forward - run.pass(-1.0);
}

}  // namespace clevis::machine
