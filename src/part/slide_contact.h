#pragma once

#include <optional>
#include <string>

namespace clevis::part {

/// Contact area of a slide's counterpart on the part, as the user says it.
struct SlideContact {
  std::string opposite;          ///< wall that faces the seat's group, or empty
  std::optional<double> length;  ///< along the slide [m]
  std::optional<double> width;   ///< across it, on flat walls [m]
  /// Of its middle from the joint's point on the counterpart, along the joint's
  /// axis there [m].
  double offset{};
};

}  // namespace clevis::part
