#pragma once

#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "assessment/ladder/governing_instants.h"
#include "assessment/models/level.h"

// How exactly the loads of each instant are solved for. Pins that turn load a
// part by as many different fields as there are instants; those of instants
// that cannot govern are made up of fewer, to a share of the tolerance.
namespace clevis::assessment {

/// Per load set what is admitted of each instant's load, over the largest [1]:
/// nothing of instants whose peak or deflection by a solution of all came near
/// the largest.
/// @return empty where that saves little, or probes want all exactly.
/// @pre no singular zone, beside which other instants may govern.
template <int dim>
std::vector<Eigen::VectorXd> admitted_load_errors(const PartJob& job,
                                                  const Level<dim>& before);

/// The same where nothing but some instants was solved before.
std::vector<Eigen::VectorXd> admitted_load_errors(
    const PartJob& job, const GoverningInstants& chosen);

/// Whether the peak is of an instant of which an error was admitted.
template <int dim>
bool peak_is_inexact(const Level<dim>& level);

/// By how much an instant of which an error was admitted may be above the peak
/// [Pa].
template <int dim>
double rise_of_inexact(const Level<dim>& level);

/// Error of the deflections of a set by what was admitted, over the largest
/// [1].
template <int dim>
double inexact_deflection(const Level<dim>& level, std::size_t set);

}  // namespace clevis::assessment
