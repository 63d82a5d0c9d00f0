#pragma once

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "dynamics/load_vibration/load_path.h"
#include "dynamics/load_vibration/response_spectrum.h"

namespace clevis::assessment {

/// Beyond the loads of the instants an oscillator may answer by so much before
/// the part is computed with its vibration [1].
inline constexpr double kPaceCounts = 1.02;

/// Beyond that of the first, oscillators of frequencies near it may answer by
/// so much before a part that does not bear it is doubted [1].
inline constexpr double kRiseCounts = 1.1;

/// The loads over a motion or a load history with those that repeat others,
/// without the cases behind them.
LoadSet motion_loads(const LoadSet& set);

/// The same as far as they are followed.
LoadSet followed_loads(const LoadSet& set);

/// How loads go on from one instant to the next.
dynamics::LoadPath::Between between_instants(const LoadSet& set);

/// Components of the forces and moments on the part's surface and of those of
/// its inertia over the motion, less those at its start, each over its largest
/// change. Those of a vector are along its own axes (acting_forces.h), so that
/// the part's frame counts for nothing. Each counts by itself, for a small
/// force across a part may stress it hundreds of times more than a large one
/// along it, and at its frequency hundreds of times again; one that changes by
/// less than a millionth of the largest change does not.
/// @param motion  of motion_loads or followed_loads.
dynamics::LoadPath load_components(const PartJob& job, const LoadSet& motion);

/// Longer than a bar of the part's size and material vibrates, free or held at
/// one end, with what the mechanism adds to its mass: by its mean thickness
/// [s]. Necks, flexures and elastic beds may vibrate slower.
double longest_period(const PartJob& job, const LoadSet& set);

/// The same of a plate that cannot leave its plane, whatever the mechanism adds
/// [s].
double longest_period_in_plane(const PartJob& job);

/// The same of a block on a neck, a flexure or a soft bed: forty times longer
/// [s].
double softest_period(const PartJob& job, const LoadSet& set);

/// Whether the loads change so slowly that no vibration of the part is excited,
/// be it as soft as softest_period() says: a test without its modes.
bool is_slow(const PartJob& job, const LoadSet& set,
             const dynamics::LoadPath& components);

/// Of oscillators with the part's first period and shorter ones.
/// @param first  period [s].
dynamics::ResponseSpectrum load_spectrum(const PartJob& job,
                                         const dynamics::LoadPath& components,
                                         double first);

/// Largest answer of oscillators of frequencies near the first over that of the
/// first itself [1].
/// @param low, high  squares of these over the first's [1].
double rise_near(const PartJob& job, const dynamics::LoadPath& components,
                 double first, double low, double high);

/// Of a part's first vibration along its longest way: 2 l/√(E/ρ) [s]. What is
/// over before the part bends may still run along it and meet its like.
double period_of_waves(const PartJob& job);

}  // namespace clevis::assessment
