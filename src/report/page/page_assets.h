#pragma once

#include <string_view>

namespace clevis::report {

// Files of viewer as they stood when clevis was built.
std::string_view viewer_script();
std::string_view viewer_style();
/// "script-src 'sha256-…'; style-src 'sha256-…'" of the two.
std::string_view viewer_policy();
/// JSON: colours of the stress from the lowest to the highest, "RRGGBB".
std::string_view viewer_colours();

}  // namespace clevis::report
