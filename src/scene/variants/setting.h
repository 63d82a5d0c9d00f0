#pragma once

#include <string>
#include <string_view>

namespace clevis::scene {

/// A value that takes the place of one of the scene's.
struct Setting {
  std::string path;   ///< e.g. "part.AB.thickness"
  std::string value;  ///< as TOML writes it, or a text without its quotes
  std::string place;  ///< "--set 2", or where the value stands in a file

  bool operator==(const Setting&) const = default;
};

/// The setting that PATH=VALUE says.
/// @throws Error U001 at `place` if there is no '=', no path or no value.
Setting parse_setting(std::string_view text, std::string place);

}  // namespace clevis::scene
