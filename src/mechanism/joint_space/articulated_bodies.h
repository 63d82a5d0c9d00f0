#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "mechanism/joint_space/joint_coordinates.h"

namespace clevis::mechanism {

/// Accelerations of a tree in the coordinates of its joints, by articulated
/// inertias from the outer bodies inwards ([Featherstone2008] 7.3), referred
/// to the centres of mass. None of it allocates.
class ArticulatedBodies {
 public:
  /// @param armatures  by velocity: inertia of what turns or slides with a
  ///   coordinate alone [kg m²] or [kg].
  ArticulatedBodies(const MechanismDefinition& definition,
                    const JointCoordinates& coordinates,
                    std::vector<double> armatures);

  /// Inertias as of coordinates.place(). @return false where a joint meets no
  ///   inertia.
  bool factor(const Configuration& x);
  /// @param wrenches  by slot, about the centres of mass [N], [N m].
  /// @param twists  by slot; nullptr: wrenches act alone.
  /// @param u_rate  of all joints [m/s²] or [rad/s²]; open ones are filled.
  void accelerate(const std::vector<SpatialForce>& wrenches,
                  const Configuration& x, const std::vector<Twist>* twists,
                  double* u_rate);
  /// Power of the drives, as of accelerate() [W]. @param u  of all joints.
  double drive_power(const double* u, const double* u_rate) const;

 private:
  using Vector3d = Eigen::Vector3d;
  using Matrix3d = Eigen::Matrix3d;
  /// Of force (f, t) by acceleration (a, α): f = A a + B α, t = Bᵀ a + C α.
  struct Inertia {
    Matrix3d A, B, C;

    Twist times(const Twist& motion) const {
      return {A * motion.v + B * motion.w,
              B.transpose() * motion.v + C * motion.w};
    }
  };
  struct Body {
    double mass{};
    Matrix3d own;     ///< inertia about the centre of mass, in L
    Inertia inertia;  ///< with all that hangs on it
    /// V with V Vᵀ = (I S) (Sᵀ I S)⁻¹ (I S)ᵀ, and the lower triangle of the
    /// Cholesky factor of Sᵀ I S with the inverse of its diagonal.
    std::array<Twist, 6> V;
    Eigen::Matrix<double, 6, 6> L;
    Eigen::Matrix<double, 6, 1> left;
    SpatialForce force;                ///< at no acceleration of the parent
    SpatialAcceleration acceleration;  ///< without the bias
  };

  void place_inertias(const Configuration& x);
  double armature(const JointCoordinates::Link& link, std::size_t j) const {
    return armatures_[static_cast<std::size_t>(link.u + link.order[j])];
  }
  bool factor_joint(std::size_t k);
  void add_to_parent(std::size_t k);
  void sweep_inwards(bool with_bias);
  void sweep_outwards(bool with_bias, double* u_rate);

  const JointCoordinates& coordinates_;
  std::vector<double> armatures_;
  std::vector<Body> bodies_;  ///< by link
};

}  // namespace clevis::mechanism
