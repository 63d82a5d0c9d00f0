#pragma once

#include <Eigen/Core>

#include "loads/load_history.h"
#include "loads/seat_traction.h"

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

/// What must be added to `tractions` so that their discrete resultant is the
/// wrench to round-off.
///
/// Quadrature does not integrate the kink of a bearing pressure exactly; the
/// rest is spread as the smallest linear traction. Moments that the points
/// cannot carry (all of them on one line) stay out.
/// @param tractions  [Pa], one column per point.
/// @param wrench     wanted, about `about`, in L.
LinearTraction correction(const GroupQuadrature& quadrature,
                          const Eigen::Matrix3Xd& tractions,
                          const Wrench& wrench, const Eigen::Vector3d& about);

/// Adds it.
void add_correction(const GroupQuadrature& quadrature, const Wrench& wrench,
                    const Eigen::Vector3d& about, Eigen::Matrix3Xd& tractions);

}  // namespace clevis::loads
