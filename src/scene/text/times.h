#pragma once

#include <vector>

#include "numerics/curves/cubic_spline.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// Whether two equal times may follow one another, as a step between them.
enum class Steps { kRefused, kAllowed };

/// Times [s]. @param least  0 or 2. @throws Error S006 unless that many
/// increase.
std::vector<double> increasing_times(const Value& times, std::size_t least,
                                     Steps steps = Steps::kRefused);

/// `ends` of a spline, or clamped.
numerics::SplineEnds read_spline_ends(StrictTable& table);

}  // namespace clevis::scene
