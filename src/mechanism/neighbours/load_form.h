#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/motion.h"
#include "mechanism/neighbours/neighbours.h"

namespace clevis::mechanism {

/// Where the mechanism acts on a body that gives way at each such place by
/// itself.
struct LoadPlace {
  enum class Kind { kJoint, kDrive, kElement } kind{};
  int index{};           ///< of joints, drives, elements
  Eigen::Vector3d p_LS;  ///< the point that moves [m]
};

/// The place of a joint or a drive; a drive without one acts at its joint's.
std::optional<std::size_t> place_of(const std::vector<LoadPlace>& places,
                                    LoadPlace::Kind kind, int index, int joint);

/// Loads and reactions of an instant as a form of second order in the motions
/// of neighbours, then of places, six each [N/m], [N], [N m].
Eigen::MatrixXd load_form(const Neighbours& neighbours,
                          const NeighbourRows& rows, const Instant& instant,
                          const std::vector<LoadPlace>& places);

}  // namespace clevis::mechanism
