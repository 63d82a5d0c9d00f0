#pragma once

#include <memory>

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// A body under a force along its contact vector c, which is constant over
/// each step; it begins at rest. Its energy is that of its scheme exactly:
/// what the force does over the way of the contact, y = cᵀu, less what a
/// damping scheme takes.
class StruckBody {
 public:
  virtual ~StruckBody() = default;

  /// @param step  [s]; factors or sines are made once for each.
  virtual void set_step(double step) = 0;
  /// Change of y at the end of a step per force over it [m/N].
  virtual double compliance() const = 0;
  /// y at the end of the next step without a force [m].
  virtual double free_contact() = 0;
  /// Makes the step that free_contact() looked at, with a force [N].
  virtual void advance(double force) = 0;

  virtual double contact() const = 0;        ///< y [m]
  virtual double strain_energy() const = 0;  ///< [J]
  virtual double energy() const = 0;         ///< kinetic and of strain [J]
  /// Displacements of all equations [m], or coordinates of a basis.
  virtual Eigen::VectorXd state() const = 0;
  virtual void rest() = 0;  ///< back to the beginning
};

/// By the midpoint rule: (K + 4/h² M) ū = M (4/h² u + 2/h u') + c P.
/// @param contact  c [1]; outlives the body, as the system does.
std::unique_ptr<StruckBody> direct_body(const LinearSystem& system,
                                        const Eigen::VectorXd& contact);

/// Coordinates q'' + ω² q = c P of M-orthonormal shapes, each propagated
/// exactly; or, with a damping time h, as the damping scheme does with steps h,
/// whatever the body's own step is.
/// @param squares  ω² [1/s²].
/// @param contact  c in the coordinates.
/// @param damping_time  0: none [s].
/// @param damping  of each, q'' + 2 ζ ω q' + ω² q = c P, over the critical,
///   below 1 [1].
std::unique_ptr<StruckBody> modal_body(const Eigen::VectorXd& squares,
                                       const Eigen::VectorXd& contact,
                                       double damping_time = 0.0,
                                       double damping = 0.0);

}  // namespace clevis::dynamics
