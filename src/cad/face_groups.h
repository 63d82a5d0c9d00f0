#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cad/face.h"
#include "part/solid_source.h"

namespace clevis::cad {

/// Groups of a solid's faces by name.
struct FaceGroups {
  std::map<std::string, std::vector<int>> faces;  ///< numbers
  /// Which faces joints have found, and which of a bore selectors left out.
  std::vector<std::string> told;
};

/// The groups that joints and selectors ask for.
/// @param points  of points_of(source), whose distances `solid` has.
/// @throws Error M017, M012 if a face would be in two groups.
FaceGroups face_groups(const Solid& solid,
                       const std::vector<Eigen::Vector3d>& points,
                       const part::SolidSource& source);

/// Name of a cylinder that no joint and no selector names, before its number.
inline constexpr const char* kRound = "round_";

/// Adds each cylinder that is in no group as round_N, N its first face, so that
/// the finite elements follow it exactly.
void add_rounds(const Solid& solid, FaceGroups& groups);

}  // namespace clevis::cad
