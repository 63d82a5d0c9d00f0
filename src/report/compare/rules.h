#pragma once

#include <span>
#include <string>
#include <string_view>

#include "report/quantities/quantity.h"

namespace clevis::report {

/// A quantity that `clevis compare` knows, with its default and the reason.
struct ToleranceRule {
  std::string quantity;  ///< "peak_von_mises"
  std::string unit;      ///< as in result.json; empty for pure numbers and text
  std::string subjects;  ///< "part, impact": whose quantity it is
  Tolerance tolerance;
  std::string_view reason;
  /// A later addition, which an old baseline may lack: that is told, and is
  /// no regression.
  Since since = Since::kSchema;
};

/// All quantities: those of the tables of a check's subjects, then those of
/// transmissions.
std::span<const ToleranceRule> tolerance_rules();

}  // namespace clevis::report
