#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// Functions of a driven motion that vanish where the law of a force element
/// goes from one piece to the next: a contact or stop touches or lets go, a
/// line passes a point of its table or turns round, friction or sliding enters
/// the narrow speeds about rest, a servo meets its limit.
class DrivenGuards {
 public:
  explicit DrivenGuards(const ForceModel& forces);

  Eigen::Index size() const { return static_cast<Eigen::Index>(all_.size()); }
  bool empty() const { return all_.empty(); }
  /// In a state at t [s]: depth and position [m] or [rad],
  /// rate and sliding [m/s] or [rad/s], a servo's effort [N] or [N m]; of a
  /// contact that lets go only the sign counts.
  Eigen::VectorXd values(const ForceModel& forces, const ForceState& acting,
                         double t) const;
  /// Their rates, per second in the units of the values; absent where
  /// the state does not give them.
  std::vector<std::optional<double>> rates(const ForceState& acting) const;
  /// Whether its zero changes anything in a state: what lets go must press.
  bool matters(Eigen::Index guard, const ForceModel& forces,
               const ForceState& acting) const;
  /// Whether loads may jump at its zero; else they bend.
  bool jumps(Eigen::Index guard) const;

 private:
  struct Guard {
    std::size_t element{};
    ElementGuard of;
  };

  std::vector<Guard> all_;
};

}  // namespace clevis::mechanism
