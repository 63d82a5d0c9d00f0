#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/motion.h"
#include "mechanism/neighbours/neighbours.h"
#include "mechanism/neighbours/swinging_form.h"

namespace clevis::mechanism {

/// What the rest of a mechanism does to small, fast motions of one of its
/// bodies at an instant: its neighbours follow by their inertia or do not give
/// way. What force elements yield stands beside that, of neighbours that follow
/// so.
///
/// A column is a wrench on the body, six rows a place: force, then moment about
/// Lo, in L. Its product with the body's motions at the places (v, ω) is a
/// motion that the neighbours share. Directions in which they are free have
/// none.
struct NeighbourInertia {
  std::vector<NeighbourPlace> places;
  Eigen::MatrixXd held;     ///< do not move; forces [1], moments [m]
  Eigen::MatrixXd weighed;  ///< w: w wᵀ are added masses [√kg], [m √kg]
  /// Skew, rows and columns as the rows above: takes speeds of the places to
  /// the wrenches that turning the neighbours' spin takes, θ' × h of a momentum
  /// h relative to the body [kg/s], [m kg/s], [m² kg/s]. Empty: none spins.
  Eigen::MatrixXd spin = {};
  /// w wᵀ are stiffness and damping of force elements [√(N/m)], [m √(N/m)];
  /// the same times √s.
  Eigen::MatrixXd sprung = {}, damped = {};
  /// Force elements that swing neighbours in ways which the places do not see:
  /// they are not in `sprung`.
  std::vector<int> left_out = {};
  /// With them; nothing: there are none.
  std::optional<SwingingNeighbours> swinging = std::nullopt;
};

/// @param instant  of a motion of the mechanism.
NeighbourInertia neighbour_inertia(const Neighbours& neighbours,
                                   const Instant& instant);

}  // namespace clevis::mechanism
