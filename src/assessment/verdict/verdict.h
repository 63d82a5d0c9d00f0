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

}  // namespace clevis::assessment
