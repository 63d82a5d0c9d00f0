#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/messages/exit_code.h"
#include "part/verdict.h"

namespace clevis::report {

/// A number with its band.
struct Banded {
  double value{}, low{}, high{};
};

/// Measure that a part of a variant is judged by.
struct VariantPart {
  std::string name;
  part::Verdict verdict{};
  double mass{};           ///< [kg]
  Banded peak;             ///< with its vibration, where that governs [Pa]
  double safety_factor{};  ///< [1]
  std::optional<double> safety_wanted;  ///< [1]
  Banded deflection;                    ///< [m]
};

/// A variant of a plan, with its result if there is one.
struct Variant {
  std::string name;
  /// Path and value of each setting.
  std::vector<std::pair<std::string, std::string>> settings;
  /// Why there is no result: "R003 …", or what the check was refused for.
  std::string missing;
  /// Of a check that was refused.
  std::optional<ExitCode> refused;
  part::Verdict verdict = part::Verdict::kNotJudged;
  std::vector<VariantPart> parts;

  bool is_known() const { return missing.empty(); }
  /// Of the parts that were checked [kg].
  double mass() const;
  /// The part with the least safety factor. @pre there are parts.
  const VariantPart& governing() const;
  /// Of all parts that were checked [m].
  double largest_deflection() const;
};

/// All variants of a plan, in its order.
struct Collection {
  std::string scene;
  std::vector<Variant> variants;

  /// Paths that variants set, in the order of the first that has them.
  std::vector<std::string> paths() const;
  /// Names of the parts, in the order of the first variant that has them.
  std::vector<std::string> part_names() const;
  /// The lightest that passes, the first of equals; none: null.
  const Variant* lightest() const;
};

/// The value of a setting; "-" if the variant leaves it to the scene.
std::string setting_of(const Variant& variant, const std::string& path);

/// Exit code of the process, as of a check with the variants for parts: the
/// first refusal's code; else 1 if one fails, 4 if one is not judged or
/// missing, 0 if all pass.
ExitCode exit_code(const Collection& collection);

}  // namespace clevis::report
