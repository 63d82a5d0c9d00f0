#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// What the rest of a mechanism does to small, fast motions of one of its
/// bodies at an instant: its neighbours, rigid and held by their own joints,
/// couplings and drives, follow by their inertia or do not give way. Forces of
/// elements do not count.
///
/// A column is a wrench on the body, six rows a place: force, then moment about
/// Lo, in L. Its product with the body's motions at the places (v, ω) is a
/// motion that the neighbours share. Directions in which they are free have
/// none.
struct NeighbourInertia {
  struct Place {
    int joint{};      ///< of the body
    bool is_drive{};  ///< what its drive holds, not the joint itself
  };
  std::vector<Place> places;
  Eigen::MatrixXd held;     ///< do not move; forces [1], moments [m]
  Eigen::MatrixXd weighed;  ///< w: w wᵀ are added masses [√kg], [m √kg]
};

/// @param instant  of a motion of the mechanism. Of more than a hundred bodies
///   those nearest by joints count.
NeighbourInertia neighbour_inertia(const MechanismDefinition& definition,
                                   const Instant& instant, BodyIndex body);

}  // namespace clevis::mechanism
