#include "assessment/models/model_list.h"

#include <algorithm>
#include <array>
#include <ranges>

#include <fmt/format.h>

#include "assessment/models/model_error.h"
#include "assessment/models/plate_models.h"
#include "assessment/models/revolution_model.h"
#include "assessment/models/solid_model.h"
#include "base/messages/errors.h"

namespace clevis::assessment {
namespace {

std::optional<ModelSettings> own_settings(const PartShape&) {
  return ModelSettings{.error = 0.0};
}

double no_error(const PartShape&) {
  return 0.0;
}

bool always(const PartShape&, const PartResult&) {
  return true;
}

bool never(const PartShape&, const PartResult&) {
  return false;
}

const std::array<Model, kModels.size()> kList = {
    {{.traits = traits_of(ModelKind::kPlaneStress),
      .why_not = why_not_plane_stress,
      .settings = plane_stress_settings,
      .make = plane_stress_model,
      .error = plane_stress_error,
      .next_may_help = always},
     {.traits = traits_of(ModelKind::kLayered),
      .why_not = why_not_layered,
      .settings = layered_settings,
      .make = layered_model,
      .error = no_error,  // its settings know it
      .next_may_help = solid_may_help},
     {.traits = traits_of(ModelKind::kRevolution),
      .why_not = why_not_revolution,
      .settings = own_settings,
      .make = revolution_model,
      .error = no_error,
      .next_may_help = never},
     {.traits = traits_of(ModelKind::kSolid),
      .why_not = why_not_solid,
      .settings = solid_settings,
      .make = solid_model,
      .error = no_error,
      .next_may_help = never}}};

/// Whether the engine that the job asks for has the model.
bool engine_has(const PartJob& job, const ModelTraits& model) {
  return job.engine != elasticity::Engine::kDealii || model.on_dealii;
}

/// @throws Error F005 if the model that the job asks for does not suit.
const Model& asked_for(const PartShape& shape) {
  const PartJob& job = shape.job();
  const Model& model = entry_of(*job.model);
  if (!engine_has(job, model.traits)) {
    throw Error("F005", "part " + job.part.name,
                fmt::format("deal.II has no model \"{}\"", model.traits.name),
                "Leave --engine out, or --model.");
  }
  if (const auto reason = model.why_not(shape)) {
    throw Error("F005", "part " + job.part.name, *reason, "Leave --model out.");
  }
  return model;
}

/// The first of some models that suits and has a trait; the last of the list if
/// none does.
template <class Models, class Trait>
const Model& first_that_suits(const Models& models, const PartShape& shape,
                              Trait trait) {
  const auto suits = [&](const Model& model) {
    return model.traits.*trait && !model.why_not(shape);
  };
  const auto found = std::ranges::find_if(models, suits);
  return found == std::ranges::end(models) ? kList.back() : *found;
}

/// Whether a few loads on a plate are solved in 3-D before its own models have
/// told which of them will do.
bool solid_is_quicker(const PartShape& shape) {
  constexpr std::size_t kFew = 10;  // of more the choice is a small part
  std::size_t instants = 0;
  for (const LoadSet& set : shape.job().load_sets) {
    instants += set.history.instants.size();
  }
  return instants <= kFew && shape.plate() &&
         shape.plate()->is_pressed_through && !why_not_solid(shape) &&
         terms_cost_more(shape.job(), shape.plate()->quadrangles);
}

}  // namespace

std::span<const Model> model_list() {
  return kList;
}

const Model& entry_of(ModelKind kind) {
  return kList[static_cast<std::size_t>(kind)];
}

std::vector<const Model*> models_for(const PartShape& shape) {
  if (shape.job().model) return {&asked_for(shape)};
  std::vector<const Model*> models;
  const bool in_space = solid_is_quicker(shape);
  for (const Model& model : kList) {
    if (in_space && model.traits.kind < ModelKind::kRevolution) continue;
    if (engine_has(shape.job(), model.traits) && !model.why_not(shape)) {
      models.push_back(&model);
    }
  }
  if (models.empty()) models.push_back(&kList.back());
  return models;
}

const Model& cheapest_in_time(const PartShape& shape) {
  const auto& wanted = shape.job().model;
  return wanted && traits_of(*wanted).answers_in_time
             ? asked_for(shape)
             : first_that_suits(kList, shape, &ModelTraits::answers_in_time);
}

const Model& finest_in_time(const PartShape& shape) {
  return first_that_suits(kList | std::views::reverse, shape,
                          &ModelTraits::answers_in_time);
}

const Model& cheapest_for_many_instants(const PartShape& shape) {
  return first_that_suits(kList, shape, &ModelTraits::suits_many_instants);
}

}  // namespace clevis::assessment
