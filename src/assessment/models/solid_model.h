#pragma once

#include <optional>
#include <string>

#include "assessment/models/fe_model.h"
#include "assessment/models/part_shape.h"

// 3-D elasticity on the cells of the part: an entry of the list of models
// (model_list.h says what each function answers).
namespace clevis::assessment {

/// Supports of the plane alone leave a part free to leave it. Where 3-D is
/// asked for, the solver says so (F001).
std::optional<std::string> why_not_solid(const PartShape& shape);
/// The error of a plate's few layers where 3-D is asked for and pressures have
/// a kink within them.
std::optional<ModelSettings> solid_settings(const PartShape& shape);
AnyFeModel solid_model(const PartShape& shape, const ModelSettings& settings);

/// @param mesh  outlives the model.
FeModel<3> solid_model(const mesh::PartMesh<3>& mesh);

}  // namespace clevis::assessment
