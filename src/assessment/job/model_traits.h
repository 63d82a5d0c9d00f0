#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace clevis::assessment {

/// Finite-element models of a part, in the order of their cost.
enum class ModelKind { kPlaneStress, kLayered, kRevolution, kSolid };

/// Traits of a model that hold for every part. Its work on a part stands
/// in models/model_list.h, in the same order.
struct ModelTraits {
  ModelKind kind{};
  std::string_view word;   ///< of `--model`
  std::string_view name;   ///< in results
  std::string_view suits;  ///< parts, loads and supports that it takes
  int dim{};               ///< displacement components
  int highest_degree{};    ///< of the displacement
  /// Legendre terms through the thickness; 0 of a model without.
  int fewest_terms{}, most_terms{};
  bool answers_in_time{};  ///< to impacts, and to loads that excite vibration
  /// Whether higher degrees lead to the solution of 3-D elasticity.
  bool is_exact{};
  bool on_dealii{};  ///< of hexahedra and quadrangles
  /// Whether its field is quick to look at for thousands of instants.
  bool suits_many_instants{};
};

/// The models, in the order of ModelKind.
inline constexpr std::array<ModelTraits, 4> kModels = {
    {{.kind = ModelKind::kPlaneStress,
      .word = "plane-stress",
      .name = "plane stress",
      .suits = "a plate along z, loaded and held on its sides and in its plane",
      .dim = 2,
      .highest_degree = 4,
      .answers_in_time = true,
      .on_dealii = true,
      .suits_many_instants = true},
     {.kind = ModelKind::kLayered,
      .word = "layered",
      .name = "2-D x thickness",
      .suits = "a plate along z, loaded and held on its sides",
      .dim = 3,
      .highest_degree = 5,
      .fewest_terms = 2,
      .most_terms = 4,
      .suits_many_instants = true},
     {.kind = ModelKind::kRevolution,
      .word = "revolution",
      .name = "axisymmetric",
      .suits = "a hollow solid of revolution, meshed in closed rings, loaded "
               "and held on whole rings",
      .dim = 3,
      .highest_degree = 4,
      .is_exact = true},
     {.kind = ModelKind::kSolid,
      .word = "3d",
      .name = "3-D",
      .suits = "every part",
      .dim = 3,
      .highest_degree = 4,
      .answers_in_time = true,
      .is_exact = true,
      .on_dealii = true,
      .suits_many_instants = true}}};

constexpr const ModelTraits& traits_of(ModelKind kind) {
  return kModels[static_cast<std::size_t>(kind)];
}

/// The model that a word of `--model` asks for; nothing if none has it.
constexpr std::optional<ModelKind> find_model(std::string_view word) {
  for (const ModelTraits& model : kModels) {
    if (model.word == word) return model.kind;
  }
  return std::nullopt;
}

}  // namespace clevis::assessment
