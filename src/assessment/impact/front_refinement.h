#pragma once

#include <vector>

#include <Eigen/Core>

#include "assessment/impact/struck_run.h"
#include "assessment/job/part_result.h"

namespace clevis::assessment {

/// Time of a wave from node to node of the longest cell, √(E/ρ) its speed: the
/// shortest front that the elements carry [s].
template <int dim>
double front_of_mesh(const mesh::PartMesh<dim>& mesh,
                     const part::Material& material, int degree);

/// Whether the blow has waves too short for the elements: it loses more than a
/// millionth of its energy where they are damped.
template <int dim>
bool makes_fronts(const StruckRun<dim>& run);

/// Whether steps for all equations would take minutes, or ring: a thousandth
/// of the energy lies in such waves, or more than a hundred shapes are needed.
template <int dim>
bool is_hard(const StruckRun<dim>& run);

/// What the length of a front makes of the largest stress.
struct FrontError {
  double below{}, above{};  ///< of it [1]
  Eigen::Index at{};        ///< the sample that `above` is of
};

/// By how much changes fall at the least when the front's length h does by
/// half: the error goes with the root of h and the contact's own rise together,
/// as of a step that decays behind its front; √2 for ideal steps, 1.7 for
/// soft contacts.
/// @param rise  of the contact force over h [1].
double slowest_fall(double rise);

/// From three runs with fronts of h, 2h and 4h. At each time, within a window
/// that fronts of 4h may be late by, the error of the largest stress is taken
/// to fall as the two changes did, by `slowest` at the least and 2 at the most;
/// the largest of what that leads to bounds the peak from above, so that a
/// front that comes late and is not seen yet counts. Below, where the peak
/// fell with h, what is left of that; at least a tenth of what is left above,
/// for the damping scheme overshoots a little behind a step.
/// @param one, two, four  largest stress of each sample, by h, 2h, 4h [Pa].
/// @param window          samples to either side.
/// @param slowest         of slowest_fall() [1].
FrontError front_error(const Eigen::VectorXd& one, const Eigen::VectorXd& two,
                       const Eigen::VectorXd& four, int window, double slowest);

/// By how much the energy that the damping of fronts took might stress a bent
/// part more [1]: its waves run apart, so the law of fronts may fail, and a
/// striker that bounces makes ever new ones. As strain in the shape at rest the
/// part ε of the blow's energy stresses √ε times as F_eq does; of contacts that
/// rise in t_c, more than two fronts h, 2 h/t_c of that is counted, for the
/// rest is carried.
template <int dim>
double stress_of_lost_energy(const StruckRun<dim>& run);

/// The blow with fronts four times, twice and as long as those of the one that
/// is judged, the last by twice the fewest shapes; what is not along a rod may
/// have stress_of_lost_energy() more. Its stress settles if less than 5 % of
/// error are left.
/// @param judged  by that degree with front_of_mesh().
/// @throws Error of StruckFace.
template <int dim>
FrontRefinement refine_front(const PartJob& job, const ImpactJob& impact,
                             const std::vector<stress::SingularZone>& zones,
                             int degree, const StruckRun<dim>& judged,
                             StruckFaces<dim>& faces);

}  // namespace clevis::assessment
