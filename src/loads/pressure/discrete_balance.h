#pragma once

#include <Eigen/Core>

#include "loads/history/load_history.h"
#include "loads/pressure/seat_traction.h"

namespace clevis::loads {

/// Quadrature points of a group as the FE integrates its tractions; also of a
/// plane model, where a weight is length times thickness.
struct GroupQuadrature {
  Eigen::Matrix3Xd points;  ///< p_LQ [m]
  Eigen::VectorXd weights;  ///< [m²], > 0
};

/// Resultant of tractions [Pa] (one column per point) about `about`.
Wrench resultant(const GroupQuadrature& quadrature,
                 const Eigen::Matrix3Xd& tractions,
                 const Eigen::Vector3d& about);

/// Brings the discrete resultant of tractions to a wrench.
///
/// Quadrature does not integrate the kink of a bearing pressure exactly; the
/// rest is spread as the smallest linear traction. Moments that the points
/// cannot carry (all of them on one line) stay out.
class DiscreteBalance {
 public:
  /// @param quadrature  outlives this.
  /// @param about       point of the wrenches, in L [m].
  DiscreteBalance(const GroupQuadrature& quadrature,
                  const Eigen::Vector3d& about);

  /// Traction to be added so that the wrench is reached to round-off [Pa].
  /// @param tractions  [Pa], one column per point.
  /// @param wrench     wanted, in L.
  LinearTraction missing(const Wrench& wrench,
                         const Eigen::Matrix3Xd& tractions) const;
  /// Adds it to the tractions [Pa].
  void correct(const Wrench& wrench, Eigen::Matrix3Xd& tractions) const;

 private:
  const GroupQuadrature* quadrature_;
  Eigen::Vector3d about_, centroid_;
  double area_;
  Eigen::Matrix3d second_moment_;
};

}  // namespace clevis::loads
