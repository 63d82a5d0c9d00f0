#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace clevis::report {

/// Inputs of the result of a check: equal for two checks that must give
/// the same numbers.
struct CheckInputs {
  std::string version;  ///< of clevis
  /// Path and value of each --set, in the order given.
  std::vector<std::pair<std::string, std::string>> settings;
  std::string scene;  ///< fingerprint of what the scene says with them
  std::optional<double> tolerance;   ///< --tolerance [1]; none: the scene's
  std::string model;                 ///< --model
  std::string engine;                ///< --engine
  std::optional<int> max_dofs = {};  ///< --max-dofs; none: what memory holds
  std::vector<std::string> parts;    ///< --part; empty: all
  /// Part and fingerprint of its geometry with what the part gives to it, of
  /// those that have one, in the order of the scene.
  std::vector<std::pair<std::string, std::string>> geometries;
  /// Part and fingerprint of its mesh, in the order of the scene.
  std::vector<std::pair<std::string, std::string>> meshes;

  bool operator==(const CheckInputs&) const = default;
};

/// `inputs` of result.json, without the version, which stands beside it.
nlohmann::ordered_json inputs_json(const CheckInputs& inputs);

}  // namespace clevis::report
