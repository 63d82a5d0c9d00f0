#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

/// A configuration that closes all joints and drives, with its Jacobian.
struct ClosedConfiguration {
  Configuration x;
  Eigen::VectorXd targets;  ///< coordinates of the drives [m] or [rad]
  std::vector<PlacedJoint> placed;
  Eigen::MatrixXd jacobian;
  numerics::JacobianFactor factor;
  double gap{};  ///< largest residual [m]
};

/// Follows the branch of positions while the drives move.
///
/// A step predicts with the first two derivatives along the drives' path and
/// corrects by Newton. It counts only if the correction is small and if the
/// derivatives at its end lead back to its start; else it is halved. So a
/// step never lands on another branch, also across a change point.
class Continuation {
 public:
  /// @param tolerance  of closure [m].
  Continuation(const ConstraintSystem& system, double tolerance)
      : system_(system), tolerance_(tolerance) {}

  /// Jacobian and gap at a configuration that is closed.
  /// @param targets  coordinates of the drives [m] or [rad].
  /// @param near  of a configuration nearby, or null.
  ClosedConfiguration close(
      Configuration x, const Eigen::VectorXd& targets,
      const numerics::JacobianFactor* near = nullptr) const;

  struct Reached {
    ClosedConfiguration at;
    double part{};  ///< how far along the way: 1 if it arrived
  };
  /// Configuration at new coordinates of the drives [m] or [rad].
  Reached follow(const ClosedConfiguration& from,
                 const Eigen::VectorXd& targets) const;

 private:
  Configuration predict(const ClosedConfiguration& from,
                        const Eigen::VectorXd& change) const;
  /// Newton's method from to.x to to.targets. @return whether it closed, with
  /// all but the Jacobian filled.
  bool correct(ClosedConfiguration& to,
               const numerics::JacobianFactor& nearby) const;
  void add_jacobian(ClosedConfiguration& closed,
                    const numerics::JacobianFactor* near) const;
  bool step(const ClosedConfiguration& from, const Eigen::VectorXd& targets,
            ClosedConfiguration& to) const;

  const ConstraintSystem& system_;
  double tolerance_;
};

}  // namespace clevis::mechanism
