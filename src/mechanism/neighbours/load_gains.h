#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/motion.h"
#include "mechanism/neighbours/load_form.h"
#include "mechanism/neighbours/neighbours.h"

namespace clevis::mechanism {

/// What loads that keep size and direction, on neighbours and on the body,
/// gain by second order at small slow motions of the places: neighbours are
/// rigid and follow, as a link that presses turns about its far pin and pushes
/// on across, or a weight on a mast has an arm. Elements' efforts stay, or grow
/// with the motion, where a table over positions has them rise;
/// moments are semitangential. Neighbours that the places do not fix come to
/// rest where loads hold them, or stay behind by their inertia.
///
/// With L the Lagrangian of loads and reactions, second order in the motions of
/// places and neighbours, the gain is −∂²L, neighbours eliminated.
/// Each place has a displacement of its point and a turn, six numbers [m],
/// [rad], in L; of motions that the joints do not leave, the gain is that of
/// the nearest that they do.
/// @return forces, then moments about the points, for unit motions, 6 n × 6 n,
///   symmetric [N/m], [N], [N m].
/// @param instant  of a motion of the mechanism. @param wanted  load factor at
///   which springs that hold bodies that are no parts yield [1].
/// Source: docs/theory/09_elasticity.md, "Buckling".
Eigen::MatrixXd load_gains(const Neighbours& neighbours, const Instant& instant,
                           const std::vector<LoadPlace>& places,
                           double wanted = 1.5);

}  // namespace clevis::mechanism
