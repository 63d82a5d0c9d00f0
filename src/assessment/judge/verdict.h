#pragma once

#include "assessment/job/part_result.h"
#include "part/part_definition.h"

namespace clevis::assessment {

/// Sets verdict and reason of a part from its limits.
///
/// Fail: the peak's band lies beyond the yield strength or beyond what the
/// safety factor allows, or the nominal stress of a zone left out does, or the
/// deflection or Euler's load breaks its limit. Pass: the whole bands are
/// within; that of a peak that is not converged with twice its reach. Not
/// judged: the peak is singular, or not converged with a band that decides
/// neither; a limit lies inside a band; nothing stresses the part; or it turns
/// or strains too far for linear theory.
void judge(const part::PartDefinition& part, PartResult& result);

/// The judged peak, or the nominal stress of what the limits leave out, if that
/// is larger [Pa].
double governing_stress(const part::PartDefinition& part,
                        const PartResult& result);

/// The largest stress and displacement in second order with which a part still
/// passes that does by linear theory: its bands are as wide in ratio, of a peak
/// that is not converged as many times its reach. Infinite where linear theory
/// does not pass it, or no limit is set [Pa], [m].
double admitted_peak(const part::PartDefinition& part,
                     const PartResult& result);
double admitted_deflection(const part::PartDefinition& part,
                           const PartResult& result);

/// Why the FE peak leaves 0.8–1.25 of the beam's; empty if it does not.
std::string explain_ratio(const PeakStress& peak, const BeamComparison& beam);

}  // namespace clevis::assessment
