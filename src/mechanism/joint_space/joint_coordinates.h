#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/joints/joint_motion.h"
#include "mechanism/mass_matrix/tree_mass.h"

namespace clevis::mechanism {

/// Coordinates of the joints of a tree: every body by the joint on which it
/// hangs, and free ones by their own placement. Coordinates are in [m], [rad],
/// of quaternions [1]; velocities in [m/s] and [rad/s].
class JointCoordinates {
 public:
  struct Link {
    std::size_t slot{};
    int parent = -1;  ///< link, or ground
    int joint = -1;   ///< or free
    JointMotionKind kind{};
    bool is_b = true;       ///< of the joint, as it stands here
    bool reversed = false;  ///< a and b are exchanged here
    double sense() const { return reversed ? -1.0 : 1.0; }
    Eigen::Index q{}, u{};  ///< of its first coordinate and velocity
    int count{};            ///< of velocities
    int open{};             ///< of them, not driven
    /// The open velocities among its own, then the driven ones.
    std::array<int, 6> order{0, 1, 2, 3, 4, 5};
  };
  /// A coordinate that a drive prescribes, of all coordinates and velocities.
  struct Driven {
    std::size_t drive{}, link{};
    Eigen::Index q{}, u{};
  };
  /// Effect of velocities u of its joint on a body, at its centre of mass: with
  /// `shift` from the parent's, and for accelerations a and turning α of the
  /// parent,
  ///
  ///     a_body = a + α × shift + Σ S_j u̇_j + bias
  ///
  /// over the open ones; what drives do stands in the bias.
  struct Motion {
    std::array<Twist, 6> S;  ///< in Link::order
    Twist bias;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  };

  /// @param frame  referred to centres of mass; outlives the result.
  /// @return nothing unless the mechanism is a tree whose joints all have
  ///   coordinates, which drives prescribe.
  static std::optional<JointCoordinates> of(
      const SolvingFrame& frame, const std::vector<DriveDefinition>& drives);

  /// Coordinate that a row of a joint measures, among all coordinates and
  /// velocities: sign times q.
  struct Measured {
    Eigen::Index q{}, u{};
    double sign = 1.0;
  };
  std::optional<Measured> measured(int joint, const JointRow& row) const;

  Eigen::Index coordinates() const { return coordinates_; }
  Eigen::Index velocities() const { return velocities_; }
  const std::vector<Link>& links() const { return links_; }  ///< inner first
  const std::vector<Motion>& motions() const { return motions_; }

  const std::vector<Driven>& driven() const { return driven_; }
  /// Indices of coordinates and velocities that no drive prescribes.
  const std::vector<Eigen::Index>& open_coordinates() const { return open_q_; }
  const std::vector<Eigen::Index>& open_velocities() const { return open_u_; }

  /// Places the bodies and fills motions(). @param q, u  of all joints.
  /// @param u_rate  driven ones count.
  void place(const double* q, const double* u, const double* u_rate,
             Configuration& x, std::vector<Twist>& twists);
  /// The inverse, on the nearest coordinates: without what violates joints.
  void read(const Configuration& x, const std::vector<Twist>& twists, double* q,
            double* u) const;
  /// Rates of the coordinates.
  void rates(const double* q, const double* u, double* rates) const;

 private:
  explicit JointCoordinates(const SolvingFrame& frame) : frame_(&frame) {}
  bool add(const TreeLink& link, bool is_driven);
  bool drive(std::size_t k, const DriveDefinition& drive);
  void list_open();
  std::size_t parent_slot(const Link& link) const {
    return link.parent < 0 ? 0
                           : links_[static_cast<std::size_t>(link.parent)].slot;
  }
  JointModel model(const Link& link) const;
  struct Joint {
    Eigen::Matrix3d axes_a;
    Eigen::Vector3d from_a, from_b;  ///< to J on b from the centres of mass
  };
  Joint place_body(std::size_t k, const JointMotion& relative,
                   Configuration& x);
  Twist put_directions(std::size_t k, const Joint& joint,
                       const JointMotion& relative, const double* u,
                       const double* u_rate, Twist& driven);
  void put_velocities(std::size_t k, const Joint& joint, const Twist& rate,
                      const Twist& driven, std::vector<Twist>& twists);

  const SolvingFrame* frame_;
  Eigen::Index coordinates_{}, velocities_{};
  std::vector<Link> links_;
  std::vector<JointModel> models_;  ///< by link
  std::vector<Motion> motions_;
  std::vector<Driven> driven_;
  std::vector<Eigen::Index> open_q_, open_u_;
};

}  // namespace clevis::mechanism
