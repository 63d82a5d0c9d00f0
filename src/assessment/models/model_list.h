#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/models/fe_model.h"
#include "assessment/models/part_shape.h"

namespace clevis::assessment {

/// Entry of the list of models: all that anybody asks of one.
struct Model {
  ModelTraits traits;
  /// Why it does not suit the part, its loads and supports; nothing if it does.
  std::optional<std::string> (*why_not)(const PartShape&);
  /// Settings that leave room for the tolerance. Nothing if the error of the
  /// model alone is above it and a better one suits. @pre it suits.
  std::optional<ModelSettings> (*settings)(const PartShape&);
  /// @param settings  of settings(), or the caller's. The shape outlives the
  ///   model. @pre it suits.
  AnyFeModel (*make)(const PartShape&, const ModelSettings& settings);
  /// Error of the model against the next at the governing instants, over the
  /// peak [1]. @pre it suits.
  double (*error)(const PartShape&);
  /// Whether the next model that suits may do better where this one's highest
  /// degree misses the tolerance.
  bool (*next_may_help)(const PartShape&, const PartResult&);
};

/// All models, the cheapest first.
std::span<const Model> model_list();
const Model& entry_of(ModelKind kind);

/// The models that suit a part, the cheapest first; the one that the job asks
/// for alone. Where none suits, the last: its solver says what is missing.
/// @throws Error F005 if the one asked for does not suit.
std::vector<const Model*> models_for(const PartShape& shape);

/// The cheapest model for impacts and vibration: that which the job asks for,
/// if it answers in time, else one that suits.
/// @throws Error F005 if the one asked for does not suit.
const Model& cheapest_in_time(const PartShape& shape);

/// The last model in the list that answers in time and suits, whatever the job
/// asks for.
const Model& finest_in_time(const PartShape& shape);

/// The cheapest model that suits and is quick to look at for thousands of
/// instants, whatever the job asks for.
const Model& cheapest_for_many_instants(const PartShape& shape);

}  // namespace clevis::assessment
