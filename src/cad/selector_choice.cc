#include "cad/selector_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "cad/select_faces.h"

namespace clevis::cad {
namespace {

using Eigen::Vector3d;
using part::CylinderSelector;
using part::FaceSelector;
using part::PlaneSelector;

/// Nine digits; what rounds to zero is 0, without a sign.
std::string number(double value, double finest) {
  return fmt::format("{:.9g}", std::round(value / finest) * finest + 0.0);
}

std::string quantity(double length) {
  constexpr double kFinest = 1e-6;  // [mm]
  return fmt::format("\"{} mm\"", number(1e3 * length, kFinest));
}

std::string quantities(const Vector3d& point) {
  return fmt::format("[{}, {}, {}]", quantity(point.x()), quantity(point.y()),
                     quantity(point.z()));
}

/// Calls that write a selector.
struct TomlOf {
  std::string operator()(const CylinderSelector& cylinder) const {
    std::string keys;
    const auto add = [&keys](const std::string& key) {
      keys += (keys.empty() ? "" : ", ") + key;
    };
    if (cylinder.diameter) {
      add("diameter = " + quantity(*cylinder.diameter));
    }
    if (cylinder.axis)
      add(fmt::format("axis = [{}]", components(*cylinder.axis)));
    if (cylinder.near) add("near = " + quantities(*cylinder.near));
    return fmt::format("{{ cylinder = {{ {} }} }}", keys);
  }
  std::string operator()(const PlaneSelector& plane) const {
    return fmt::format(
        "{{ plane = {{ normal = [{}]{} }} }}", components(plane.normal),
        plane.through ? ", through = " + quantities(*plane.through) : "");
  }
  std::string operator()(const part::NearestSelector& nearest) const {
    return fmt::format("{{ nearest = {} }}", quantities(nearest.point));
  }
  std::string operator()(const part::LabelSelector& wanted) const {
    return fmt::format("{{ label = {:?} }}", wanted.label);
  }
  std::string operator()(const std::vector<FaceSelector>& all) const {
    std::string list;
    for (const FaceSelector& one : all) {
      list += (list.empty() ? "" : ", ") + toml_text(one);
    }
    return fmt::format("{{ all_of = [{}] }}", list);
  }
};

}  // namespace

std::string components(const Vector3d& v) {
  constexpr double kFinest = 1e-9;
  return fmt::format("{}, {}, {}", number(v.x(), kFinest),
                     number(v.y(), kFinest), number(v.z(), kFinest));
}

SelectorChoice choice_of(const PinBore& bore) {
  const CylinderSelector by_diameter{
      .diameter = bore.diameter, .near = std::nullopt, .axis = std::nullopt};
  CylinderSelector by_axis = by_diameter, by_place = by_diameter;
  by_axis.axis = bore.axis;
  by_place.near = bore.middle;
  std::vector<FaceSelector> pieces;
  for (const Cylinder& piece : bore.pieces) {
    CylinderSelector one = by_diameter;
    one.near = piece.point;
    pieces.push_back({one, ""});
  }
  return {.faces = bore.faces(),
          .with_others = false,
          .selectors = {{by_diameter, ""},
                        {by_axis, ""},
                        {by_place, ""},
                        {std::move(pieces), ""}}};
}

SelectorChoice choice_of(const Face& plane) {
  return {.faces = {plane.number},
          .with_others = true,
          .selectors = {{PlaneSelector{plane.normal, std::nullopt}, ""},
                        {PlaneSelector{plane.normal, plane.centre}, ""},
                        {part::NearestSelector{plane.centre}, ""}}};
}

std::vector<Vector3d> points_of(const std::vector<SelectorChoice>& choices) {
  part::SolidSource source;
  for (const SelectorChoice& choice : choices) {
    for (const FaceSelector& selector : choice.selectors) {
      source.faces.push_back({"", selector});
    }
  }
  return points_of(source);
}

std::optional<FaceSelector> chosen(const Solid& solid,
                                   const std::vector<Vector3d>& points,
                                   const SelectorChoice& choice) {
  for (const FaceSelector& selector : choice.selectors) {
    try {
      std::vector<int> found = select_faces(solid, points, selector);
      std::ranges::sort(found);
      if (choice.with_others ? std::ranges::includes(found, choice.faces)
                             : found == choice.faces) {
        return selector;
      }
    } catch (const Error&) {  // it means several, or none: the next one may do
    }
  }
  return std::nullopt;
}

std::string toml_text(const FaceSelector& selector) {
  return std::visit(TomlOf(), selector.what);
}

}  // namespace clevis::cad
