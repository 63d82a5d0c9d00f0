#include "report/variants/variant_reader.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/text/json_node.h"
#include "report/text/json_text.h"

namespace clevis::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using part::Verdict;

constexpr double kMegapascal = 1e6, kMillimetre = 1e-3;

Verdict verdict_of(const JsonNode& node) {
  const std::string word = node.at("verdict").text();
  for (const Verdict verdict : {Verdict::kPass, Verdict::kFail}) {
    if (word == part::text(verdict)) return verdict;
  }
  return Verdict::kNotJudged;
}

/// A value and its band under two keys.
Banded banded(const JsonNode& node, const char* value, const char* band,
              double unit) {
  const auto ends = node.at(band).numbers<2>();
  return {node.at(value).number() * unit, ends[0] * unit, ends[1] * unit};
}

/// Measure that the part is judged by: its vibration where that governs, its
/// peak away from singular zones where the limits leave them out.
Banded judged_peak(const JsonNode& part) {
  if (part.has("vibration") && part.at("vibration").has("governs") &&
      part.at("vibration").at("governs").flag()) {
    return banded(part.at("vibration"), "peak_MPa", "band_MPa", kMegapascal);
  }
  const bool excludes =
      part.at("limits").at("singular_zones").text() == "exclude";
  const char* key = "peak_outside_singular_zones";
  return banded(part.at(excludes && part.has(key) ? key : "peak_von_mises"),
                "value_MPa", "band_MPa", kMegapascal);
}

VariantPart read_part(const JsonNode& node) {
  VariantPart part;
  part.name = node.at("name").text();
  part.verdict = verdict_of(node);
  part.mass = node.at("mass_kg").number();
  part.peak = judged_peak(node);
  part.safety_factor = node.at("safety_factor").number();
  if (node.at("limits").has("safety_factor")) {
    part.safety_wanted = node.at("limits").at("safety_factor").number();
  }
  part.deflection =
      banded(node, "deflection_mm", "deflection_band_mm", kMillimetre);
  return part;
}

/// Whether the result is that of the plan. Meshes that it makes of a geometry
/// are its own affair; the plan has the others.
bool has_inputs(ordered_json found, const CheckInputs& wanted) {
  ordered_json expected = inputs_json(wanted);
  if (!found["meshes"].is_object()) return false;
  for (const auto& [part, mesh] : expected["meshes"].items()) {
    if (found["meshes"].value(part, ordered_json()) != mesh) return false;
  }
  found.erase("meshes");
  expected.erase("meshes");
  return found == expected;
}

void read_result(const fs::path& file, const Plan& plan,
                 const CheckInputs& inputs, Variant& variant) {
  const ordered_json json = read_json(file);
  const JsonNode document(json, file.string() + ":");
  if (document.at("schema").number() != kSchema ||
      document.at("version").text() != plan.version) {
    variant.missing = "R003 the result is of another clevis than the plan";
    return;
  }
  if (!document.has("inputs") || !json["inputs"].is_object() ||
      !has_inputs(json["inputs"], inputs)) {
    variant.missing = "R003 the result is of other inputs than planned";
    return;
  }
  if (!document.at("complete").flag()) {
    variant.missing = "R003 the check was interrupted";
    return;
  }
  for (const JsonNode& failure : document.at("failures").elements()) {
    variant.missing =
        fmt::format("{} {}: {}", failure.at("code").text(),
                    failure.at("place").text(), failure.at("problem").text());
    variant.refused = static_cast<ExitCode>(
        static_cast<int>(failure.at("exit_code").number()));
    return;
  }
  variant.verdict = verdict_of(document);
  for (const JsonNode& part : document.at("parts").elements()) {
    variant.parts.push_back(read_part(part));
  }
}

void read_refusal(const fs::path& file, Variant& variant) {
  const ordered_json json = read_json(file);
  const JsonNode error = JsonNode(json, file.string() + ":").at("error");
  variant.missing =
      fmt::format("{} {}: {}", error.at("code").text(),
                  error.at("place").text(), error.at("problem").text());
  variant.refused =
      static_cast<ExitCode>(static_cast<int>(error.at("exit_code").number()));
}

Variant without_result(const PlannedVariant& planned) {
  Variant variant;
  variant.name = planned.name;
  variant.settings = planned.inputs.settings;
  return variant;
}

/// A result of what is planned stands, however often other inputs were refused
/// since.
Variant read_variant(const fs::path& folder, const Plan& plan,
                     const PlannedVariant& planned) {
  Variant variant = without_result(planned);
  const fs::path result = folder / planned.name / "result.json";
  const fs::path refusal = folder / planned.name / "error.json";
  std::error_code ignored;
  try {
    variant.missing = "R003 there is no result";
    const bool is_refused = fs::is_regular_file(refusal, ignored);
    if (fs::is_regular_file(result, ignored)) {
      variant.missing.clear();
      read_result(result, plan, planned.inputs, variant);
      if (variant.is_known() || !is_refused) return variant;
      variant = without_result(planned);
    }
    if (is_refused) read_refusal(refusal, variant);
  } catch (const Error& error) {
    variant = without_result(planned);
    variant.missing =
        fmt::format("{} {}: {}", error.code(), error.place(), error.problem());
    variant.refused = error.exit_code();
  }
  return variant;
}

}  // namespace

Collection read_collection(const fs::path& folder) {
  const Plan plan = read_plan(folder);
  Collection collection{plan.scene, {}};
  for (const PlannedVariant& planned : plan.variants) {
    collection.variants.push_back(read_variant(folder, plan, planned));
  }
  return collection;
}

}  // namespace clevis::report
