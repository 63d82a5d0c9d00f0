#pragma once

#include "app/commands.h"

namespace clevis::app {

// `clevis check` lives in a library of its own that is loaded on demand: only
// it pays for loading deal.II (0.3–0.6 s).
inline constexpr const char* kCheckPlugin = "clevis_check.so";
inline constexpr const char* kCheckEntryName = "clevis_check";
using CheckEntry = ExitCode(const Options& options);

}  // namespace clevis::app
