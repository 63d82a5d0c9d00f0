#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

namespace clevis::part {

/// A number that the user gives to a part's .geo in place of its own.
struct GeometryParameter {
  std::string name;   ///< of a DefineConstant
  double value{};     ///< lengths in units of the mesh, ratios as they are [1]
  std::string place;  ///< file:line:column, or the option that gives it
};

/// "name=value" lines, the fewest digits that read back to the same bits: what
/// tells the meshes of one .geo apart.
inline std::string text_of(const std::vector<GeometryParameter>& parameters) {
  std::string text;
  for (const GeometryParameter& parameter : parameters) {
    text += fmt::format("{}={}\n", parameter.name, parameter.value);
  }
  return text;
}

}  // namespace clevis::part
