#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "part/geometry_parameter.h"

namespace clevis::app {

/// The variables that a .geo names.
struct GeometryConstants {
  std::set<std::string, std::less<>> constants;  ///< of DefineConstant[...]
  std::set<std::string, std::less<>> assigned;   ///< by statements beside them
};

/// Constants that the text of a .geo defines, without comments and texts.
GeometryConstants geometry_constants(std::string_view text);

/// Refuses parameters that a .geo would not take: gmsh gives them
/// to DefineConstant alone, and a later assignment replaces them.
/// @throws Error S007 at the parameter.
void require_constants(const std::filesystem::path& geometry,
                       const std::vector<part::GeometryParameter>& parameters);

}  // namespace clevis::app
