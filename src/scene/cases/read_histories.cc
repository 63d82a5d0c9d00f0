#include "scene/cases/read_histories.h"

#include <algorithm>
#include <string>
#include <utility>

#include <Eigen/Core>
#include <fmt/format.h>

#include "scene/cases/load_table.h"
#include "scene/cases/read_supports.h"
#include "scene/cases/row_loads.h"
#include "scene/text/name_index.h"
#include "scene/text/suggestion.h"

namespace clevis::scene {
namespace {

using Eigen::Vector3d;
using part::SeriesSeat;

enum class Frame { kPart, kWorld };

/// Part of the sum of all loads that inertia takes up without a word in the
/// scene.
constexpr double kUsualImbalance = 0.01;

SeriesSeat read_seat(const std::string& name, const Value& value,
                     bool is_face) {
  SeriesSeat seat{.name = name, .group = "", .is_face = is_face};
  if (!value.is_table()) {
    seat.group = value.text();
    return seat;
  }
  StrictTable table(value, "part.history.pins");
  seat.group = table["group"].text();
  if (const auto about = table.find("about")) {
    seat.about = about->vector(Dimension::kLength);
  }
  return seat;
}

/// Seats that the scene names, under `pins` or `faces`.
void read_seats(StrictTable& table, std::string_view key,
                const LoadTable& loads, std::vector<SeriesSeat>& seats) {
  const auto value = table.find(key);
  if (!value) return;
  std::vector<std::string_view> known;
  for (const LoadColumns& columns : loads.loads()) {
    if (columns.has_wrench()) known.push_back(columns.name);
  }
  for (const auto& [name, entry] : value->entries()) {
    if (std::ranges::find(known, name) == known.end()) {
      throw entry.refusal(
          "S007", fmt::format("names no force of the file: \"{}\"", name),
          suggestion(name, known));
    }
    if (std::ranges::find(seats, name, &SeriesSeat::name) != seats.end()) {
      throw entry.refusal("S010", "stands under `pins` and `faces`",
                          "A force acts through a pin or on a face.");
    }
    seats.push_back(read_seat(name, entry, key == "faces"));
  }
}

/// Forces that the scene does not name press as pins on bores of their name.
void add_unnamed_seats(const LoadTable& loads, std::vector<SeriesSeat>& seats) {
  for (const LoadColumns& columns : loads.loads()) {
    if (!columns.has_wrench() ||
        std::ranges::find(seats, columns.name, &SeriesSeat::name) !=
            seats.end()) {
      continue;
    }
    seats.push_back({.name = columns.name, .group = columns.name});
  }
}

Frame read_frame(StrictTable& table, const LoadTable& loads) {
  const auto value = table.find("frame");
  const Frame frame = value ? value->choice<Frame>({{"part", Frame::kPart},
                                                    {"world", Frame::kWorld}})
                            : Frame::kPart;
  if (frame == Frame::kWorld && !loads.has_orientation()) {
    throw value->refusal("S003", "= \"world\", but the file has no orientation",
                         "Give the columns orientation_w, _x, _y and _z, the "
                         "part's frame in the world.");
  }
  return frame;
}

std::vector<RowLoads> rows_of(const LoadTable& loads,
                              const std::vector<SeriesSeat>& seats, Frame frame,
                              const Vector3d& gravity) {
  std::vector<const LoadColumns*> columns;
  for (const SeriesSeat& seat : seats) {
    columns.push_back(
        &*std::ranges::find(loads.loads(), seat.name, &LoadColumns::name));
  }
  std::vector<RowLoads> rows;
  for (std::size_t row = 0; row < loads.rows(); ++row) {
    part::SeriesInstant instant;
    instant.time = loads.time(row);
    for (const LoadColumns* column : columns) {
      instant.forces.push_back(loads.vector(row, column->force));
      instant.moments.push_back(loads.vector(row, column->moment));
    }
    for (const LoadColumns& column : loads.loads()) {
      if (column.pressure < 0) continue;
      instant.pressures.push_back(loads.value(row, column.pressure));
    }
    instant.acceleration = loads.acceleration(row) - gravity;
    instant.angular_velocity = loads.angular_velocity(row);
    instant.angular_acceleration = loads.angular_acceleration(row);
    rows.push_back({.loads = std::move(instant), .place = loads.place(row)});
    if (frame == Frame::kWorld) {
      rows.back().orientation = loads.orientation(row);
    }
  }
  if (frame == Frame::kWorld) require_known_turns(rows);
  return rows;
}

part::BetweenRows read_interpolation(StrictTable& table) {
  const auto value = table.find("interpolation");
  return value ? value->choice<part::BetweenRows>(
                     {{"unknown", part::BetweenRows::kUnknown},
                      {"linear", part::BetweenRows::kLinear}})
               : part::BetweenRows::kUnknown;
}

double read_largest_imbalance(StrictTable& table, bool has_acceleration) {
  const auto value = table.find("largest_imbalance");
  if (!value) return kUsualImbalance;
  if (!has_acceleration) {
    throw value->refusal(
        "S010", "stands beside a file without accelerations",
        "Inertia then takes up all that the loads leave: leave the key out.");
  }
  const double share = value->quantity(Dimension::kRatio);
  if (!(share >= 0.0 && share <= 1.0)) {
    throw value->refusal("S006", "is out of range",
                         "Give a part of the load from 0 % to 100 %.");
  }
  return share;
}

/// @throws Error S007.
void require_pin(const Value& bore, const std::vector<SeriesSeat>& seats) {
  std::vector<std::string_view> known;
  for (const SeriesSeat& seat : seats) {
    if (!seat.is_face) known.push_back(seat.group);
  }
  if (std::ranges::find(known, bore.text()) != known.end()) return;
  throw bore.refusal(
      "S007",
      fmt::format("= \"{}\" is no bore that a pin of the file presses on",
                  bore.text()),
      suggestion(bore.text(), known));
}

part::LoadSeries read_history(StrictTable& table,
                              const std::filesystem::path& folder) {
  part::LoadSeries series;
  series.name = table["name"].title();
  series.place = table.place();
  const LoadTable loads(folder / table["file"].text());
  read_seats(table, "pins", loads, series.seats);
  read_seats(table, "faces", loads, series.seats);
  add_unnamed_seats(loads, series.seats);
  for (const LoadColumns& columns : loads.loads()) {
    if (columns.pressure >= 0) series.pressurized.push_back(columns.name);
  }
  if (series.seats.empty() && series.pressurized.empty() &&
      !loads.has_acceleration() && !loads.spins()) {
    throw table["file"].refusal(
        "S003", "has no load",
        "Give columns NAME.force_x [N], GROUP.pressure [MPa], "
        "acceleration_x [m/s^2] or angular_velocity_x [rad/s].");
  }
  const auto gravity = table.find("gravity");
  const Frame frame = read_frame(table, loads);
  const std::vector<RowLoads> rows = rows_of(
      loads, series.seats, frame,
      gravity ? gravity->vector(Dimension::kAcceleration) : Vector3d::Zero());
  series.between = read_interpolation(table);
  series.instants = instants_in_part(rows, series.between);
  series.has_acceleration = loads.has_acceleration();
  series.largest_imbalance =
      read_largest_imbalance(table, series.has_acceleration);
  series.held_by_pin = read_held_by_pin(table, [&](const Value& bore) {
    require_pin(bore, series.seats);
  });
  series.fixed = read_fixed(table);
  series.foundations = read_foundations(table);
  return series;
}

}  // namespace

std::vector<part::LoadSeries> read_histories(
    StrictTable& part, const std::filesystem::path& file) {
  std::vector<part::LoadSeries> all;
  NameIndex names("history");
  for (StrictTable& table : part.tables("history")) {
    const Value name = table["name"];
    names.add(name.title(), name);
    all.push_back(read_history(table, file.parent_path()));
  }
  return all;
}

}  // namespace clevis::scene
