#include "scene/solids/read_faces.h"

#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {
namespace {

part::CylinderSelector read_cylinder(StrictTable table) {
  part::CylinderSelector selector;
  if (const auto diameter = table.find("diameter")) {
    selector.diameter = diameter->positive(Dimension::kLength);
  }
  if (const auto near = table.find("near")) {
    selector.near = near->vector(Dimension::kLength);
  }
  if (const auto axis = table.find("axis")) selector.axis = axis->direction();
  return selector;
}

part::PlaneSelector read_plane(StrictTable table) {
  part::PlaneSelector selector;
  selector.normal = table["normal"].direction();
  if (const auto through = table.find("through")) {
    selector.through = through->vector(Dimension::kLength);
  }
  return selector;
}

part::FaceSelector read_selector(const Value& value) {
  constexpr std::string_view kKinds[] = {"cylinder", "plane", "nearest",
                                         "label", "all_of"};
  StrictTable table(value, "part.faces");
  std::vector<std::string_view> given;
  for (const std::string_view kind : kKinds) {
    if (table.has(kind)) given.push_back(kind);
  }
  if (given.size() != 1) {
    throw value.refusal(given.empty() ? "S003" : "S010",
                        given.empty() ? "says not which faces are meant"
                                      : "has several selectors",
                        "Give one of cylinder, plane, nearest, label and "
                        "all_of; the last takes a "
                        "list of the others.");
  }
  part::FaceSelector selector{{}, value.place()};
  if (given.front() == "cylinder") {
    selector.what = read_cylinder(table.table("cylinder"));
  } else if (given.front() == "plane") {
    selector.what = read_plane(table.table("plane"));
  } else if (given.front() == "nearest") {
    selector.what =
        part::NearestSelector{table["nearest"].vector(Dimension::kLength)};
  } else if (given.front() == "label") {
    selector.what = part::LabelSelector{table["label"].text()};
  } else {
    std::vector<part::FaceSelector> all;
    for (const Value& one : table["all_of"].elements()) {
      all.push_back(read_selector(one));
    }
    selector.what = std::move(all);
  }
  return selector;
}

}  // namespace

std::vector<part::NamedFaces> read_faces(const Value& table) {
  std::vector<part::NamedFaces> faces;
  for (const auto& [group, value] : table.entries()) {
    require_name(group, value);
    faces.push_back({group, read_selector(value)});
  }
  return faces;
}

}  // namespace clevis::scene
