#pragma once

#include <optional>

#include <Eigen/Core>

#include "loads/history/load_history.h"
#include "loads/pressure/discrete_balance.h"

namespace clevis::loads {

/// Pressure of a rigid counterpart that touches walls without play through an
/// even elastic layer that can only press: p = max(0, −n·(d + θ × r)), d and θ
/// the small motion of the counterpart whose pressures make the wrench. On one
/// flat wall it is linear while the force lies in the middle third, and lifts
/// off beyond; between two walls that face each other it is linear, on the one
/// or the other by its sign, so that a body that tilts presses at both ends.
///
/// Components that normal pressures cannot carry (along the walls) are left
/// out, as is round-off: DiscreteBalance adds both.
/// @param outward  the part's unit normals at the points.
/// @param wrench   on the part, about `about`, in L.
/// @return tractions on the part [Pa]; nothing if the walls would have to pull.
/// Source: docs/theory.md, "Slides".
std::optional<Eigen::Matrix3Xd> wall_pressure(const GroupQuadrature& quadrature,
                                              const Eigen::Matrix3Xd& outward,
                                              const Wrench& wrench,
                                              const Eigen::Vector3d& about);

}  // namespace clevis::loads
