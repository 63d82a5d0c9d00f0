#pragma once

#include <istream>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clevis::calculix {

/// Solution of CalculiX in one step, at the nodes; SI.
struct StepResult {
  Eigen::Matrix3Xd displacement;  ///< [m]
  /// xx, yy, zz, xy, yz, xz: extrapolated from the integration points and
  /// averaged over the elements at a node [Pa].
  Eigen::Matrix<double, 6, Eigen::Dynamic> stress;
};

/// Reads the ASCII .frd of a deck by write_deck().
/// @param nodes  of the deck.
/// @param place  the file, for messages.
/// @throws Error I004 if the file ends early, holds no number where one must
///   stand, or lacks a node.
std::vector<StepResult> read_frd(std::istream& in, int nodes,
                                 const std::string& place);

}  // namespace clevis::calculix
