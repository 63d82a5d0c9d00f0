#pragma once

#include <Eigen/Core>

#include "mechanism/neighbours/neighbours.h"

namespace clevis::mechanism {

/// How neighbours follow the places, in unknowns of ConstraintSystem.
struct Following {
  Eigen::MatrixXd admitted;  ///< motions of places → those that rows leave
  Eigen::MatrixXd slow;      ///< → neighbours, by least kinetic energy
  Eigen::MatrixXd loose;  ///< motions of neighbours that the places do not see
  Eigen::MatrixXd sprung = {};     ///< likewise, that springs hold
  Eigen::VectorXd stiffness = {};  ///< of these [N/m]
};

/// By constraints, of what they leave by least kinetic energy.
/// @param of_places  rows of the body as rows of the places' motions.
Following following_of(const Neighbours& neighbours, const NeighbourRows& rows,
                       const Eigen::MatrixXd& of_places);

/// Loose motions that springs hold harder than loads push follow the places by
/// these: `slow` as if they did not yield.
/// @param springs  rows of force elements times the root of their stiffness: of
///   motions of neighbours, then of places, × rows [√(N/m)].
/// @param form  of loads, of the same motions [N/m].
void follow_springs(const Eigen::MatrixXd& springs, const Eigen::MatrixXd& form,
                    Following& following);

}  // namespace clevis::mechanism
