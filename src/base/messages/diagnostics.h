#pragma once

#include <span>
#include <string_view>

#include "base/messages/exit_code.h"

namespace clevis {

/// One entry of the catalogue behind `clevis explain CODE`.
struct Diagnostic {
  std::string_view code;
  ExitCode exit_code;
  std::string_view title;
  std::string_view explanation;  ///< what it means, why it is refused, remedy
};

/// All diagnostics, sorted by code.
std::span<const Diagnostic> diagnostics();

/// The entry of `code`; the entry of X001 (internal error) if there is none.
const Diagnostic& find_diagnostic(std::string_view code);

}  // namespace clevis
