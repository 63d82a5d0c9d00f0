#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "mechanism/joints/configuration.h"
#include "mechanism/joints/joint_motion.h"

namespace clevis::mechanism {

/// A body of a tree and the joint on which it hangs.
struct JointLink {
  std::size_t slot{};
  int parent = -1;  ///< link, or ground
  std::size_t parent_slot{};
  int joint = -1;  ///< or free
  JointMotionKind kind{};
  bool is_b = true;       ///< of the joint, as it stands here
  bool reversed = false;  ///< a and b are exchanged here
  double sense() const { return reversed ? -1.0 : 1.0; }  ///< [1]
  Eigen::Index q{}, u{};  ///< of its first coordinate and velocity
  int count{};            ///< of velocities
  int open{};             ///< of them, not driven
  /// The open velocities among its own, then the driven ones.
  std::array<int, 6> order{0, 1, 2, 3, 4, 5};
};

/// Effect of velocities u of its joint on a body, at its centre of mass: with
/// `shift` from the parent's, and for accelerations a and turning α of the
/// parent,
///
///     a_body = a + α × shift + Σ S_j u̇_j + bias
///
/// over the open ones; what drives do stands in the bias.
struct LinkMotion {
  std::array<Twist, 6> S;                           ///< in JointLink::order
  Twist bias;                                       ///< [m/s²], [rad/s²]
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< [m]
};

/// Of one joint: coordinates [m], [rad], [1], velocities [m/s], [rad/s] and
/// their rates, of which driven ones count.
struct JointValues {
  const double* q;
  const double* u;
  const double* u_rate;
};

/// Places the body of a link and gives it its velocity, behind its parent.
/// @param model  of the joint, referred to the centres of mass.
/// @param x, twists  by slot [m], [m/s], [rad/s]; the body's are filled.
void place_link(const JointLink& link, const JointModel& model,
                const JointValues& values, Configuration& x,
                std::vector<Twist>& twists, LinkMotion& motion);

}  // namespace clevis::mechanism
