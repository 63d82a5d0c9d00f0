#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// Loads on the bodies of a mechanism in one state of a motion.
struct LoadState {
  ForceState forces;
  /// By slot, about the centres of mass, weight among them [N], [N m].
  std::vector<SpatialForce> wrenches;
  /// Of AppliedLoads::efforts(), as their laws say [N], [N m].
  Eigen::VectorXd efforts_by_law;

  /// Power of all wrenches [W]. @param twists  by slot [m/s], [rad/s].
  double power(const std::vector<Twist>& twists) const;
};

/// Loads on the bodies of a mechanism beside those of joints and drives: weight
/// and force elements. None of it allocates but none(). Times are in seconds
/// [s], efforts in [N] or [N m], states of force elements in units of their
/// own.
class AppliedLoads {
 public:
  /// @param frame  referred to the bodies' centres of mass.
  AppliedLoads(const MechanismDefinition& definition,
               const SolvingFrame& frame);

  /// A state without loads, of the sizes that evaluate() fills.
  LoadState none() const;
  /// @param internal  states of the force elements.
  void evaluate(double t, const Configuration& x,
                const std::vector<Twist>& twists, const double* internal,
                LoadState& state) const;

  ForceModel& forces() { return forces_; }
  const ForceModel& forces() const { return forces_; }

  /// See OdeSystem: efforts of springs, stops, servos and gas along lines.
  Eigen::Index efforts() const {
    return static_cast<Eigen::Index>(stiff_.size());
  }
  void hold_efforts(const Eigen::VectorXd* given) { given_ = given; }
  /// Force element of an effort.
  std::size_t element_of_effort(Eigen::Index k) const {
    return stiff_[static_cast<std::size_t>(k)];
  }
  /// Friction acts by its tangents at a state, which it puts.
  void hold_tangents(double t, const Configuration& x,
                     const std::vector<Twist>& twists, const double* internal,
                     LoadState& state);
  void release_tangents() { forces_.release_tangents(); }

 private:
  void take_efforts(LoadState& state) const;

  ForceModel forces_;
  std::vector<double> masses_;  ///< by slot
  Eigen::Vector3d gravity_;
  std::vector<std::size_t> stiff_;          ///< elements of efforts()
  const Eigen::VectorXd* given_ = nullptr;  ///< see hold_efforts()
};

}  // namespace clevis::mechanism
