#pragma once

#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/job/part_result.h"
#include "elasticity/vibration/seat_shapes.h"

namespace clevis::assessment {

/// Spin about the part's longest way, at most [rad/s].
double spin_about_length(const PartJob& job, const LoadSet& set);

/// Whether that spin is fast beside the part's first period, so that its shapes
/// turn in its own frame. @param first  period [s].
bool spins_fast(const PartJob& job, const LoadSet& motion, double first);

/// Whether loads stand so still in space that they excite no vibration of a
/// part that spins fast; beside those that turn with it, which bend it further
/// by its spin alone (second order). A part whose sections are uneven sags
/// differently as it turns: they do where that is slow. @param first  period
/// [s].
bool stand_in_space(const PartJob& job, const LoadSet& motion, double first);

/// A part that turns about another axis than its length.
struct TurningPart {
  double speed{};  ///< fastest over the first frequency [1]
  /// By how much its own inertia, which pulls it straight and pulls on what it
  /// displaces outwards, moves the square of the first frequency at most [1].
  double shift{};
};

/// @param first  period at rest [s].
TurningPart turning_part(const PartJob& job, const LoadSet& motion,
                         double first);

/// Why a part's vibration is not known where bodies that spin on it move its
/// frequencies to those of its loads, and what they may rise by decides about a
/// limit; empty: it is.
std::string not_known_by_spin(
    const PartJob& job, const PartResult& result, const LoadSet& motion,
    const std::vector<elasticity::SeatShapes::Moved>& frequencies);

}  // namespace clevis::assessment
