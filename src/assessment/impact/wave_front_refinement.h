#pragma once

#include <vector>

#include <Eigen/Core>

#include "assessment/impact/struck_run.h"
#include "assessment/job/part_result.h"

namespace clevis::assessment {

/// Time of a wave from node to node of the longest cell, √(E/ρ) its speed: the
/// shortest front that the elements carry [s].
template <int dim>
double shortest_wave_front(const mesh::PartMesh<dim>& mesh,
                           const part::Material& material, int degree);

/// Whether the blow has waves too short for the elements: it loses more than a
/// millionth of its energy where they are damped.
template <int dim>
bool has_short_wave_fronts(const StruckRun<dim>& run);

/// Whether steps for all equations would take minutes, or ring: a thousandth
/// of the energy lies in such waves, or more than a hundred shapes are needed.
template <int dim>
bool is_hard(const StruckRun<dim>& run);

/// Relative error of the peak stress caused by the length of the shortest wave
/// front resolved.
struct WaveFrontError {
  double below{}, above{};  ///< of it [1]
  Eigen::Index at{};        ///< the sample that `above` is of
};

/// Least factor by which changes of the stress fall when the front's length h
/// is halved. The error goes with the root of h and the contact's rise
/// together, as behind a step that decays; √2 for ideal steps, 1.7 for soft
/// contacts.
/// @param rise  of the contact force over h [1].
double slowest_fall(double rise);

/// Error by three runs with fronts of h, 2h and 4h. At each time, within the
/// window by which fronts of 4h may be late, the error of the largest stress is
/// taken to fall by the ratio of the two changes, between `slowest` and 2. The
/// largest extrapolated stress bounds the peak from above, so that a front that
/// arrives late counts. The error below is that where the peak fell with h, and
/// at least a tenth of the error above: the damping scheme overshoots a little
/// behind a step.
/// @param one, two, four  largest stress of each sample, by h, 2h, 4h [Pa].
/// @param window          samples to either side.
/// @param slowest         of slowest_fall() [1].
WaveFrontError wave_front_error(const Eigen::VectorXd& one,
                                const Eigen::VectorXd& two,
                                const Eigen::VectorXd& four, int window,
                                double slowest);

/// Relative stress that the energy lost in the damping of fronts could add in a
/// bent part [1]. Bending waves disperse, so the law of fronts may fail, and a
/// striker that bounces excites new ones. The part ε of the blow's energy, as
/// strain of the static shape, stresses √ε times as F_eq does. Where the
/// contact's rise time t_c exceeds two fronts h, only 2 h/t_c of that counts:
/// the elements resolve the rest.
template <int dim>
double stress_of_lost_energy(const StruckRun<dim>& run);

/// Repeats the blow with fronts four times, twice and once as long as those of
/// the judged run, the last with twice the fewest shapes. Parts that are not
/// struck along a rod get stress_of_lost_energy() besides. The stress has
/// settled if less than 5 % of error are left.
/// @param judged  by that degree with shortest_wave_front().
/// @throws Error of StruckFace.
template <int dim>
WaveFrontRefinement refine_wave_front(
    const PartJob& job, const ImpactJob& impact,
    const std::vector<stress::SingularZone>& zones, int degree,
    const StruckRun<dim>& judged, StruckFaces<dim>& faces);

}  // namespace clevis::assessment
