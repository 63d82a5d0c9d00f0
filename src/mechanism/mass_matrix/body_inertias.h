#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"
#include "mechanism/mass_matrix/constrained_mass.h"

namespace clevis::mechanism {

/// Masses of the bodies, and their inertias about the centres of mass M. Bodies
/// by slot: 0 is the ground, which has none.
class BodyInertias {
 public:
  /// @param frame  frame_at_centres().
  BodyInertias(const MechanismDefinition& definition,
               const SolvingFrame& frame);

  double mass(std::size_t slot) const { return bodies_[slot].mass; }  ///< [kg]
  /// F with F Fᵀ = length² inertia⁻¹, in L [1/√kg].
  const Eigen::Matrix3d& turn_factor(std::size_t slot) const {
    return bodies_[slot].turn_factor;
  }
  /// Angular momentum [N m s] of a body with orientation R that turns at w
  /// [rad/s], in the frame of these.
  Eigen::Vector3d spin(std::size_t slot, const Eigen::Matrix3d& R,
                       const Eigen::Vector3d& w) const {
    return R * (bodies_[slot].inertia * (R.transpose() * w));
  }
  /// Of the bodies [J].
  double kinetic_energy(const Configuration& x,
                        const std::vector<Twist>& twists) const;
  /// Acceleration along a lever [m/s²] per force along it [N], were the body
  /// free [1/kg].
  double free_response(int slot, const Eigen::Matrix3d& R,
                       const SpatialForce& lever) const;

  /// Gives the mass matrix the blocks that orientations do not change: all of
  /// planar bodies, those of displacements of others.
  void put_constant_blocks(ConstrainedMass& mass) const;
  /// Gives it the others.
  void put_turned_blocks(const Configuration& x, ConstrainedMass& mass) const;

 private:
  struct Body {
    double mass{};                ///< [kg]
    Eigen::Matrix3d inertia;      ///< about Cm, in L [kg m²]
    Eigen::Matrix3d turn_factor;  ///< see turn_factor()
    Eigen::Matrix3d turn_root;    ///< its inverse
    double inertia_z{};           ///< planar: about the normal [kg m²]
  };
  bool planar_;
  double length_;
  std::vector<Body> bodies_;
};

}  // namespace clevis::mechanism
