#include "scene/line_elements/read_table.h"

#include <vector>

#include <fmt/format.h>

#include "scene/text/times.h"

namespace clevis::scene {
namespace {

/// Two or more, far enough apart to be told apart as a motion passes.
std::vector<double> increasing_positions(const Value& value,
                                         Dimension dimension) {
  std::vector<double> positions;
  for (const Value& each : value.elements()) {
    positions.push_back(each.quantity(dimension));
    constexpr double kApart = 1e-9;  // [m] or [rad]
    const std::size_t n = positions.size();
    if (n > 1 && !(positions[n - 1] - positions[n - 2] > kApart)) {
      throw each.refusal("S006", "does not increase",
                         "Give positions that increase.");
    }
  }
  if (positions.size() < 2) {
    throw value.refusal("S006", "has fewer than two entries",
                        "Give two positions or more.");
  }
  return positions;
}

}  // namespace

mechanism::LineLaw read_table(const LineSource& source) {
  StrictTable& table = source.table;
  const LineUnits units = source.units();
  mechanism::TableLaw law;
  if (table.has("positions")) {
    law.positions = increasing_positions(table["positions"], units.coordinate);
  } else {
    law.times = increasing_times(table["times"], 1, Steps::kAllowed);
  }
  const Value efforts = table["efforts"];
  for (const Value& e : efforts.elements()) {
    law.efforts.push_back(e.quantity(units.effort));
  }
  const bool over_time = law.positions.empty();
  const std::size_t points =
      over_time ? law.times.size() : law.positions.size();
  if (points != law.efforts.size()) {
    throw efforts.refusal(
        "S010",
        fmt::format("has {} entries for {} {}", law.efforts.size(), points,
                    over_time ? "times" : "positions"),
        "Give one effort for each.");
  }
  return law;
}

}  // namespace clevis::scene
