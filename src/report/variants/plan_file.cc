#include "report/variants/plan_file.h"

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/text/json_node.h"
#include "report/text/json_text.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

constexpr const char* kPlanAgain =
    "Plan again with this clevis: `clevis plan` writes it anew.";

std::vector<std::pair<std::string, std::string>> table_of(
    const JsonNode& node, const ordered_json& json, const char* name) {
  node.at(name).texts();  // refuses what is no table of texts
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [key, value] : json[name].items()) {
    rows.emplace_back(key, JsonNode(value, key).text());
  }
  return rows;
}

/// @param json  the node's.
CheckInputs inputs_of(const JsonNode& node, const ordered_json& json) {
  CheckInputs inputs;
  inputs.settings = table_of(node, json, "set");
  inputs.geometries = table_of(node, json, "geometries");
  inputs.meshes = table_of(node, json, "meshes");
  inputs.scene = node.at("scene").text();
  if (node.has("tolerance")) inputs.tolerance = node.at("tolerance").number();
  inputs.model = node.at("model").text();
  inputs.engine = node.at("engine").text();
  for (const JsonNode& part : node.at("parts").elements()) {
    inputs.parts.push_back(part.text());
  }
  return inputs;
}

/// @throws Error I003 as of any document that clevis wrote.
Plan plan_of(const std::filesystem::path& file) {
  const ordered_json json = read_json(file);
  const JsonNode document(json, file.string() + ":");
  if (document.at("schema").number() != kSchema) {
    throw Error("I003", file.string(), "the plan has another schema",
                kPlanAgain);
  }
  Plan plan{document.at("version").text(),
            document.at("scene").text(),
            document.at("file").text(),
            {}};
  const auto nodes = document.at("variants").elements();
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    const JsonNode inputs = nodes[v].at("inputs");
    plan.variants.push_back({nodes[v].at("name").text(),
                             inputs_of(inputs, json["variants"][v]["inputs"])});
  }
  return plan;
}

}  // namespace

std::string plan_json(const Plan& plan) {
  ordered_json variants = ordered_json::array();
  for (const PlannedVariant& variant : plan.variants) {
    variants.push_back(
        {{"name", variant.name}, {"inputs", inputs_json(variant.inputs)}});
  }
  return json_text({{"schema", kSchema},
                    {"version", plan.version},
                    {"scene", plan.scene},
                    {"file", plan.file.string()},
                    {"variants", variants}});
}

Plan read_plan(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kPlanFile;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw Error("I007", file.string(), "there is no such plan",
                "Give the folder that `clevis plan` wrote to.");
  }
  try {
    return plan_of(file);
  } catch (const Error& error) {
    if (error.code() != "I003") throw;
    throw Error("I003", error.place(), error.problem(), kPlanAgain);
  }
}

}  // namespace clevis::report
