#pragma once

#include <string>

#include "assessment/ladder/degree_ladder.h"

namespace clevis::assessment {

/// Band of a probe by its own sequence and by the cells that meet there, whose
/// errors have opposite signs; of a displacement by what it has still to go.
/// @param index  of the probe among all of the part's, case after case.
/// @param tolerance  relative to the value [1].
/// @return [Pa], of a displacement [m].
template <int dim>
stress::Band probe_band(const DegreeLadder<dim>& ladder, std::size_t index,
                        const std::string& load_case,
                        const std::string& quantity, double tolerance);

/// Whether the stresses at all probes are known within the tolerance [1] of the
/// peak: what is asked for beside it may come to rest later.
template <int dim>
bool probes_are_within(const DegreeLadder<dim>& ladder, const PartJob& job,
                       double tolerance);

}  // namespace clevis::assessment
