#pragma once

#include <memory>
#include <optional>

#include "assessment/models/rung.h"
#include "mesh/derived/revolution.h"

namespace clevis::assessment {

/// A part that is a solid of revolution with all loads and supports on faces
/// that go all round. Nothing if it is none or the job asks for another model.
/// @throws Error F005 if the job asks for this model and it does not fit.
std::optional<mesh::Revolution> revolution_model(const PartJob& job);

/// What solving by Fourier terms has come to, over all load sets.
struct RevolutionProgress {
  int degree{};         ///< solved last
  int harmonics{};      ///< terms of the series, the most of a load set
  double truncation{};  ///< von Mises of its upper half of orders, largest at
                        ///< all corners and instants [Pa]
};

/// @param solid  outlives the rung.
/// @param progress  filled by every solve.
Rung<3> revolution_rung(const mesh::Revolution& solid,
                        std::shared_ptr<RevolutionProgress> progress);

}  // namespace clevis::assessment
