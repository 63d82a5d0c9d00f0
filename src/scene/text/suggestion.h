#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clevis::scene {

/// "Did you mean …?" by edit distance, if one is near, and the known names.
std::string suggestion(std::string_view name,
                       const std::vector<std::string_view>& known);

}  // namespace clevis::scene
