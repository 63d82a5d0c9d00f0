#pragma once

#include <string>

#include "assessment/job/part_result.h"

namespace clevis::assessment {

/// Beyond these small displacements do not hold: a turn of 5° changes levers by
/// 9 % and their lengths by 0.4 %, a strain of 5 % every length by as much.
inline constexpr double kLargestRotation = 5.0 / 180.0 * 3.14159265358979;
inline constexpr double kLargestStrain = 0.05;

/// How far beyond its bound a motion is [1].
double reach(const FiniteMotion& motion);

/// Both largest of two, with the instant of what reaches farther.
FiniteMotion farther(const FiniteMotion& one, const FiniteMotion& other);

/// Why linear theory does not hold for the part; empty if it does.
std::string beyond_small_displacements(const FiniteMotion& motion);

}  // namespace clevis::assessment
