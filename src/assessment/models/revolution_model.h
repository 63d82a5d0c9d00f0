#pragma once

#include <optional>
#include <string>

#include "assessment/models/fe_model.h"
#include "assessment/models/part_shape.h"

// Fourier terms about an axis: an entry of the list of models (model_list.h
// says what each function answers).
namespace clevis::assessment {

std::optional<std::string> why_not_revolution(const PartShape& shape);
/// Its remark counts the terms that were solved, and says what those left out
/// bring: it holds of all solutions of the model so far.
AnyFeModel revolution_model(const PartShape& shape,
                            const ModelSettings& settings);

}  // namespace clevis::assessment
