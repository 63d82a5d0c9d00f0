#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/forces/force_model.h"
#include "mechanism/mass_matrix/constrained_mass.h"

namespace clevis::mechanism {

/// Friction that is proportional to the reaction of its own joint, which in
/// turn depends on the friction: both are found together, from the reactions
/// without that friction and with one unit of each.
/// Source: docs/theory.md, "Joint friction that follows the reaction".
class FollowingFriction {
 public:
  /// @param columns, most_rows  of the factored mass.
  FollowingFriction(const ForceModel& forces, const ConstraintSystem& system,
                    int columns, int most_rows);

  bool empty() const { return lines_.empty(); }
  /// Gives the lines their loads and efforts.
  /// @param mass  factored. @param acting  given the loads and efforts.
  /// @param a, lambda  those without this friction; with it on return.
  /// @return power of the friction [W]; NaN if no efforts fit, or several may:
  ///   the joint jams.
  double solve(const ForceModel& forces, ConstrainedMass& mass,
               ForceState& acting, Eigen::VectorXd& a, Eigen::VectorXd& lambda);
  /// Element that grew fastest when the last solve() failed so.
  std::optional<std::size_t> self_locking() const { return self_locking_; }

 private:
  void respond(const ForceModel& forces, const ForceState& acting,
               ConstrainedMass& mass);
  bool contracts();
  bool find_efforts();
  /// Across the line's axis, see end_forces() [N].
  Eigen::Matrix2d pressing(std::size_t line,
                           const Eigen::VectorXd& lambda) const;

  struct Line {
    std::size_t element{};
    std::vector<int> rows;  ///< of its joint, across its axis
    Guide guide;
    double q{};  ///< of the line [m] or [rad]
    double per_load{};
    Eigen::Matrix2d free = Eigen::Matrix2d::Zero();  ///< without friction [N]
  };
  const ConstraintSystem& system_;
  std::vector<Line> lines_;
  std::optional<std::size_t> self_locking_;
  Eigen::MatrixXd levers_, accelerations_, multipliers_;  ///< of unit efforts
  Eigen::MatrixXd newton_;
  Eigen::VectorXd none_, Q_, a_, lambda_, efforts_, rest_, growth_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace clevis::mechanism
