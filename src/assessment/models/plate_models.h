#pragma once

#include <optional>
#include <string>

#include "assessment/models/fe_model.h"
#include "assessment/models/part_shape.h"

// Plane stress, and Legendre terms through the thickness: entries of the list
// of models (model_list.h says what each function answers).
namespace clevis::assessment {

std::optional<std::string> why_not_plane_stress(const PartShape& shape);
std::optional<ModelSettings> plane_stress_settings(const PartShape& shape);
AnyFeModel plane_stress_model(const PartShape& shape,
                              const ModelSettings& settings);
/// Model error, measured with thickness terms of the same degree, over the peak
/// [1].
double plane_stress_error(const PartShape& shape);

std::optional<std::string> why_not_layered(const PartShape& shape);
std::optional<ModelSettings> layered_settings(const PartShape& shape);
AnyFeModel layered_model(const PartShape& shape, const ModelSettings& settings);
/// Hexahedra of the same mesh help where too few terms are what is missing:
/// where the degree falls short they do too.
bool solid_may_help(const PartShape& shape, const PartResult& result);

}  // namespace clevis::assessment
