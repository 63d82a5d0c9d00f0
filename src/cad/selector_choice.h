#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cad/face.h"
#include "cad/pin_bores.h"
#include "part/solid_source.h"

namespace clevis::cad {

/// Faces that a scene is to name, and selectors that may mean them.
struct SelectorChoice {
  std::vector<int> faces;  ///< numbers
  bool with_others{};      ///< whether other faces may come along: of its plane
  std::vector<part::FaceSelector> selectors;  ///< the shortest first
};

SelectorChoice choice_of(const PinBore& bore);

/// @param plane  a plane face.
SelectorChoice choice_of(const Face& plane);

/// Points whose distances from the faces a choice needs [m].
std::vector<Eigen::Vector3d> points_of(
    const std::vector<SelectorChoice>& choices);

/// The shortest selector that finds the faces; absent if none does.
/// @param solid  with the distances of `points`.
std::optional<part::FaceSelector> chosen(
    const Solid& solid, const std::vector<Eigen::Vector3d>& points,
    const SelectorChoice& choice);

/// As a scene has it: { cylinder = { diameter = "16 mm" } }.
std::string toml_text(const part::FaceSelector& selector);

/// Components with nine digits, as joints need them: "1, 0, 0".
std::string components(const Eigen::Vector3d& v);

}  // namespace clevis::cad
