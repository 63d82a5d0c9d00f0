#pragma once

#include <string>

#include "report/variants/collection.h"

namespace clevis::report {

/// One row per variant, RFC 4180, units in the header: its settings, verdict,
/// what is missing, mass, the part of least safety with its peak and band, the
/// largest deflection; then the same for each part.
std::string collection_csv(const Collection& collection);

}  // namespace clevis::report
