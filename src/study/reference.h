#pragma once

#include <span>

#include "study/run.h"

namespace clevis::study {

/// The value at the end of a sequence of rising degree, and how far it may be
/// off: Aitken's extrapolation where the last changes shrink steadily
/// (0 < d₂/d₁ ≤ 1/2), else the last value; the uncertainty is half the last
/// change, or what the extrapolation adds if that is more. Both are in the
/// units of the sequence.
/// @pre not empty.
Reference extrapolate(std::span<const double> sequence);

/// Sets the references of a study from the last of `series` (coarsest first)
/// that has three runs, or as many as any before it; probes with a published
/// value keep that.
/// @param published  per probe, SI.
void set_references(std::span<const std::string> series,
                    std::span<const std::optional<double>> published,
                    PartStudy& study);

}  // namespace clevis::study
