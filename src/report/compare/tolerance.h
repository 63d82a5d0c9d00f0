#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "report/compare/rules.h"

namespace clevis::report {

/// @pre `quantity` stands in tolerance_rules().
const ToleranceRule& rule_of(std::string_view quantity);

/// "0.2 %", "1e-6", "0.05 mm", "0.2 % + 0.01 MPa", "note" or "off"; nothing
/// if the text is none of these or a number is negative.
std::optional<Tolerance> parse_tolerance(std::string_view text,
                                         std::string_view unit);

/// The text that parse_tolerance() reads back; "exact" for zero.
std::string text(const Tolerance& tolerance, std::string_view unit);

/// The defaults with what the user replaced.
class Tolerances {
 public:
  /// @throws Error `code` at `place` if the quantity is unknown or the text
  ///   is no tolerance for it.
  void set(std::string_view quantity, std::string_view text,
           std::string_view code, const std::string& place);

  /// @pre `quantity` stands in tolerance_rules().
  const Tolerance& of(std::string_view quantity) const;

 private:
  std::map<std::string, Tolerance, std::less<>> replaced_;
};

}  // namespace clevis::report
