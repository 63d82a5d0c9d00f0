#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// Loads on the bodies of a mechanism beside those of joints and drives: weight
/// and force elements. None of it allocates. Times are in seconds [s], efforts
/// in [N] or [N m], states of force elements in units of their own.
class AppliedLoads {
 public:
  /// @param frame  referred to the bodies' centres of mass.
  AppliedLoads(const MechanismDefinition& definition,
               const SolvingFrame& frame);

  /// @param internal  states of the force elements.
  void evaluate(double t, const Configuration& x,
                const std::vector<Twist>& twists, const double* internal);
  /// By slot, about the centres of mass [N], [N m], as of evaluate().
  const std::vector<Twist>& wrenches() const { return wrenches_; }
  /// Power of all wrenches [W].
  double power(const std::vector<Twist>& twists) const;
  /// Mass of a body [kg].
  double mass(std::size_t slot) const { return masses_[slot]; }

  ForceModel& forces() { return forces_; }
  const ForceModel& forces() const { return forces_; }

  /// See OdeSystem: efforts of springs, stops, servos and gas along lines.
  Eigen::Index efforts() const {
    return static_cast<Eigen::Index>(stiff_.size());
  }
  void hold_efforts(const Eigen::VectorXd* given) { given_ = given; }
  const Eigen::VectorXd& efforts_by_law() const { return by_law_; }
  const ActingElement& element_of_effort(Eigen::Index k) const {
    return forces_.element(stiff_[static_cast<std::size_t>(k)]);
  }
  void hold_tangents(double t, const Configuration& x,
                     const std::vector<Twist>& twists, const double* internal);
  void release_tangents() { forces_.release_tangents(); }

 private:
  void take_efforts();

  ForceModel forces_;
  std::vector<double> masses_;  ///< by slot
  Eigen::Vector3d gravity_;
  std::vector<Twist> wrenches_;
  std::vector<std::size_t> stiff_;          ///< elements of efforts()
  const Eigen::VectorXd* given_ = nullptr;  ///< see hold_efforts()
  Eigen::VectorXd by_law_;
};

}  // namespace clevis::mechanism
