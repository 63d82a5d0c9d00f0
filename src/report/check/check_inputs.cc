#include "report/check/check_inputs.h"

#include <nlohmann/json.hpp>

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

ordered_json table_json(
    const std::vector<std::pair<std::string, std::string>>& rows) {
  ordered_json table = ordered_json::object();
  for (const auto& [key, value] : rows) table[key] = value;
  return table;
}

}  // namespace

ordered_json inputs_json(const CheckInputs& inputs) {
  ordered_json tolerance;  // null: the scene's
  if (inputs.tolerance) tolerance = *inputs.tolerance;
  ordered_json json{{"set", table_json(inputs.settings)},
                    {"scene", inputs.scene},
                    {"tolerance", tolerance},
                    {"model", inputs.model},
                    {"engine", inputs.engine},
                    {"parts", inputs.parts},
                    {"geometries", table_json(inputs.geometries)},
                    {"meshes", table_json(inputs.meshes)}};
  if (inputs.max_dofs) json["max_dofs"] = *inputs.max_dofs;
  return json;
}

}  // namespace clevis::report
