#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace clevis::report {

/// How a quantity of a result is held against its baseline.
enum class Treatment {
  kCompare,  ///< a change above the tolerance is a regression
  kNote,     ///< a change is told, and is no regression
  kIgnore,   ///< not looked at
};

/// Allowed change = relative |baseline| + absolute.
struct Tolerance {
  Treatment treatment{};
  double relative{};  ///< [1]
  double absolute{};  ///< in the unit of the quantity
};

/// A quantity that `clevis compare` knows, with its default and the reason.
struct ToleranceRule {
  std::string_view quantity;  ///< "peak_von_mises"
  std::string_view unit;      ///< as in result.json; empty for text and counts
  Tolerance tolerance;
  std::string_view reason;
};

/// All quantities, in the order of docs/results.md.
std::span<const ToleranceRule> tolerance_rules();

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
