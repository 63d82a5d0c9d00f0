#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/holds/mean_motions.h"

namespace clevis::elasticity {

/// A piece of a bore that hangs together, as that of one ear of a fork.
struct BorePiece {
  Eigen::Vector3d centre;      ///< on the bore's axis [m]
  std::vector<bool> has_node;  ///< by node of the part
  NodeFunctionals<3> motions;  ///< mean ones about the centre
};

/// Pieces of a group on a cylinder; none where it is one, or on no cylinder.
/// @param whole  its mean motions, by linear tractions.
/// @param positions  of all nodes [m].
std::vector<BorePiece> bore_pieces(const Discretization<3>& discretization,
                                   const std::string& group,
                                   const NodeFunctionals<3>& whole,
                                   const Eigen::Matrix3Xd& positions);

}  // namespace clevis::elasticity
