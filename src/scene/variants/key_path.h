#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace clevis::scene {

/// A step of a path through a scene: a key or the name of an entry, or the
/// number of an entry, from 0.
using PathStep = std::variant<std::string, std::size_t>;

/// The steps of `part.AB.parameters.fillet`, `joint.B.at.AB[0]` or
/// `part."A.2".thickness`.
/// @throws Error S007 at `place` if the text is no such path.
std::vector<PathStep> parse_path(std::string_view text,
                                 const std::string& place);

/// The path as far as `steps` of it, as messages name it.
std::string text_of(const std::vector<PathStep>& path, std::size_t steps);

}  // namespace clevis::scene
