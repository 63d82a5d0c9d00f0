#pragma once

#include <optional>
#include <vector>

#include "assessment/impact/struck_run.h"
#include "beam/estimates/struck_part.h"

namespace clevis::assessment {

/// The part as a bar that beam theory knows; nothing if it is none, or is held
/// otherwise than clamped at one face.
std::optional<beam::BarOfPart> bar_of(const PartJob& job,
                                      const ImpactJob& impact);

/// Rows of the beam-theory models of a blow, as published in [RotorLine] and
/// corrected.
void add_beam_rows(const beam::BarOfPart& bar, const loads::Strike& strike,
                   std::vector<ImpactRow>& rows);

/// Dynamic over static stress by the corrected beam, where it has one [1].
std::optional<double> beam_factor(const beam::BarOfPart& bar,
                                  const loads::Strike& strike);

/// Row of elements in time.
/// @param error  of the stress [1].
template <int dim>
ImpactRow struck_row(const StruckRun<dim>& run, int degree, double error);

/// Which side of the judged model a model is on, and why.
/// @param face  way of the struck face by the judged model [m].
/// @param part_stiffness  of the struck face [N/m].
std::string remark_on(const ImpactRow& row, const ImpactResult& impact,
                      double face, double part_stiffness);

}  // namespace clevis::assessment
