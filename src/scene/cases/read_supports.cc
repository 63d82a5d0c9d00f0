#include "scene/cases/read_supports.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace clevis::scene {
namespace {

constexpr const char* kHowFixed =
    "Name what is held of each group: fixed = { GROUP = [\"x\", \"y\", \"z\"] "
    "}.";

std::array<bool, 3> read_components(const Value& value) {
  if (!value.is_array()) {
    throw value.refusal("S005", "is no array", kHowFixed);
  }
  const auto elements = value.elements();
  std::array<bool, 3> is_fixed{};
  if (elements.empty()) {
    throw value.refusal("S006", "holds nothing",
                        "Name at least one of \"x\", \"y\", \"z\".");
  }
  for (const Value& element : elements) {
    is_fixed.at(element.choice<std::size_t>({{"x", 0}, {"y", 1}, {"z", 2}})) =
        true;
  }
  return is_fixed;
}

/// A number: the same in all directions; a table: across and along the face.
part::Foundation read_foundation(const Value& value) {
  if (!value.is_table()) {
    const double all = value.positive(Dimension::kBedding);
    return {all, all};
  }
  part::Foundation foundation;
  StrictTable table(value, "part.case.foundation");
  if (const auto normal = table.find("normal")) {
    foundation.normal = normal->positive(Dimension::kBedding);
  }
  if (const auto tangential = table.find("tangential")) {
    foundation.tangential = tangential->positive(Dimension::kBedding);
  }
  if (foundation == part::Foundation{}) {
    throw value.refusal("S006", "holds nothing",
                        "Give normal, tangential or both.");
  }
  return foundation;
}

}  // namespace

part::Supports read_fixed(StrictTable& table) {
  const auto value = table.find("fixed");
  if (value && !value->is_table()) {
    throw value->refusal("S005", "is no table of groups", kHowFixed);
  }
  return read_groups<std::array<bool, 3>>(table, "fixed", read_components);
}

part::Foundations read_foundations(StrictTable& table) {
  return read_groups<part::Foundation>(table, "foundation", read_foundation);
}

std::vector<std::string> read_held_by_pin(
    StrictTable& table, const std::function<void(const Value&)>& require) {
  std::vector<std::string> bores;
  const auto value = table.find("held_by_pin");
  if (!value) return bores;
  for (const Value& element : value->elements()) {
    const std::string bore = element.text();
    if (std::ranges::find(bores, bore) != bores.end()) {
      throw element.refusal("S008", fmt::format("names \"{}\" twice", bore),
                            "Name each bore once.");
    }
    require(element);
    bores.push_back(bore);
  }
  if (bores.empty()) {
    throw value->refusal("S006", "holds nothing", "Name at least one bore.");
  }
  if (table.has("fixed") || table.has("foundation")) {
    throw value->refusal("S010",
                         "and `fixed` or `foundation` hold the part together",
                         "Pins hold a part that is free but for them: leave "
                         "one of the two out.");
  }
  return bores;
}

}  // namespace clevis::scene
