#include "report/variants/collection.h"

#include <algorithm>
#include <cassert>

namespace clevis::report {

using part::Verdict;

double Variant::mass() const {
  double mass = 0.0;
  for (const VariantPart& part : parts) mass += part.mass;
  return mass;
}

const VariantPart& Variant::governing() const {
  assert(!parts.empty());
  return *std::ranges::min_element(parts, {}, &VariantPart::safety_factor);
}

double Variant::largest_deflection() const {
  double largest = 0.0;
  for (const VariantPart& part : parts) {
    largest = std::max(largest, part.deflection.value);
  }
  return largest;
}

std::vector<std::string> Collection::paths() const {
  std::vector<std::string> paths;
  for (const Variant& variant : variants) {
    for (const auto& [path, value] : variant.settings) {
      if (std::ranges::find(paths, path) == paths.end()) paths.push_back(path);
    }
  }
  return paths;
}

std::vector<std::string> Collection::part_names() const {
  std::vector<std::string> names;
  for (const Variant& variant : variants) {
    for (const VariantPart& part : variant.parts) {
      if (std::ranges::find(names, part.name) == names.end()) {
        names.push_back(part.name);
      }
    }
  }
  return names;
}

const Variant* Collection::lightest() const {
  const Variant* lightest = nullptr;
  for (const Variant& variant : variants) {
    if (!variant.is_known() || variant.verdict != Verdict::kPass) continue;
    if (variant.parts.empty()) continue;
    if (lightest == nullptr || variant.mass() < lightest->mass()) {
      lightest = &variant;
    }
  }
  return lightest;
}

std::string setting_of(const Variant& variant, const std::string& path) {
  const auto found = std::ranges::find(
      variant.settings, path, &std::pair<std::string, std::string>::first);
  return found == variant.settings.end() ? "-" : found->second;
}

ExitCode exit_code(const Collection& collection) {
  const auto& variants = collection.variants;
  const auto refused = std::ranges::find_if(variants, [](const Variant& v) {
    return v.refused.has_value();
  });
  if (refused != variants.end()) return *refused->refused;
  const auto any = [&](Verdict verdict) {
    return std::ranges::any_of(variants, [verdict](const Variant& v) {
      return v.verdict == verdict;
    });
  };
  if (any(Verdict::kFail)) return ExitCode::kLimitExceeded;
  return any(Verdict::kNotJudged) || variants.empty() ? ExitCode::kNotJudged
                                                      : ExitCode::kPass;
}

}  // namespace clevis::report
