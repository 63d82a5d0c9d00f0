#pragma once

#include "assessment/job/part_result.h"
#include "part/part_definition.h"

namespace clevis::assessment {

/// The peak that decides: with vibration where that was computed.
PeakStress governing_peak(const PartResult& result);

/// The largest stress that the limits allow [Pa].
double allowed_stress(const part::PartDefinition& part);

/// Reaches of its band with which a peak that is not converged has to lie
/// within a limit [1]: what is wider than the tolerance is an estimate from
/// degrees that are far from settled; beside a singular zone, whose own cells
/// may be as large as the zone, the more so.
double reaches_wanted(const PartResult& result);

/// Whether the part is within its limits of stress and deflection, band and
/// all, and would not be if both rose by a factor [1].
bool rise_decides(const part::PartDefinition& part, const PartResult& result,
                  double rise);

/// Over all load sets.
Swing largest_swing(const PartResult& result);

/// The largest stress and displacement in second order with which a part still
/// passes that does by linear theory: its bands are as wide in ratio, of a peak
/// that is not converged as many times its reach. Infinite where linear theory
/// does not pass it, or no limit is set [Pa], [m].
double admitted_peak(const part::PartDefinition& part,
                     const PartResult& result);
double admitted_deflection(const part::PartDefinition& part,
                           const PartResult& result);

}  // namespace clevis::assessment
