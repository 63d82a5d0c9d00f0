#include "scene/cases/load_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/values/quantity.h"
#include "scene/csv/csv_column.h"
#include "scene/csv/csv_text.h"
#include "scene/text/document.h"

namespace clevis::scene {

using Eigen::Vector3d;

/// Where a column belongs, and in what unit its fields may be.
struct LoadTable::Slot {
  int* index;
  Dimension dimension;
};

namespace {

constexpr std::string_view kComponents = "xyz";

/// Component of a title that ends in _x, _y or _z.
std::optional<std::size_t> component_of(std::string_view title,
                                        std::string_view stem) {
  if (title.size() != stem.size() + 2 || !title.starts_with(stem) ||
      title[stem.size()] != '_') {
    return std::nullopt;
  }
  const std::size_t component = kComponents.find(title.back());
  if (component == kComponents.npos) return std::nullopt;
  return component;
}

double number_of(const CsvField& field) {
  std::string_view text = field.text;
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  text = text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, failure] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() ||
      !std::isfinite(value)) {
    throw Error("S005", field.place,
                fmt::format("{:?} is no number", field.text.substr(0, 40)),
                "Write finite numbers with a decimal point; units stand in the "
                "header.");
  }
  return value;
}

double factor_of(const CsvColumn& column, Dimension dimension) {
  if (column.unit.empty() && dimension == Dimension::kRatio) return 1.0;
  if (column.unit.empty()) {
    throw Error(
        "S004", column.place,
        fmt::format("the column {:?} has no unit", column.name.substr(0, 80)),
        fmt::format("Write it behind the title in brackets, one of {}.",
                    accepted_units(dimension)));
  }
  return parse_quantity("1 " + column.unit, dimension, column.place);
}

}  // namespace

bool LoadColumns::has_wrench() const {
  const auto stands = [](int column) {
    return column >= 0;
  };
  return std::ranges::any_of(force, stands) ||
         std::ranges::any_of(moment, stands);
}

bool LoadTable::has(const VectorColumns& columns) {
  return std::ranges::any_of(columns, [](int column) {
    return column >= 0;
  });
}

LoadColumns& LoadTable::load(const std::string& name,
                             const std::string& place) {
  const auto found = std::ranges::find(loads_, name, &LoadColumns::name);
  if (found != loads_.end()) return *found;
  loads_.push_back({.name = name, .place = place});
  return loads_.back();
}

std::optional<LoadTable::Slot> LoadTable::slot_of(const std::string& title,
                                                  const std::string& place) {
  if (title == "time") return Slot{&time_, Dimension::kTime};
  if (const auto c = component_of(title, "acceleration")) {
    return Slot{&acceleration_.at(*c), Dimension::kAcceleration};
  }
  if (const auto c = component_of(title, "angular_velocity")) {
    return Slot{&omega_.at(*c), Dimension::kAngularVelocity};
  }
  if (const auto c = component_of(title, "angular_acceleration")) {
    return Slot{&alpha_.at(*c), Dimension::kAngularAcceleration};
  }
  if (title == "orientation_w") {
    return Slot{&orientation_.front(), Dimension::kRatio};
  }
  if (const auto c = component_of(title, "orientation")) {
    return Slot{&orientation_.at(*c + 1), Dimension::kRatio};
  }
  const std::size_t dot = title.rfind('.');
  if (dot == std::string::npos || dot == 0) return std::nullopt;
  const std::string name = title.substr(0, dot);
  const std::string_view quantity = std::string_view(title).substr(dot + 1);
  if (const auto c = component_of(quantity, "force")) {
    return Slot{&load(name, place).force.at(*c), Dimension::kForce};
  }
  if (const auto c = component_of(quantity, "moment")) {
    return Slot{&load(name, place).moment.at(*c), Dimension::kTorque};
  }
  if (quantity == "pressure") {
    return Slot{&load(name, place).pressure, Dimension::kStress};
  }
  return std::nullopt;
}

LoadTable::LoadTable(const std::filesystem::path& file) {
  const auto rows = parse_csv(read_text(file), file.string());
  if (rows.size() < 2) {
    throw Error("S012", file.string() + ":1:1",
                rows.empty() ? "the table is empty" : "the table has no row",
                "Write a header, and a row for each time.");
  }
  const std::vector<CsvColumn> columns = csv_columns(rows.front());
  std::vector<double> factors;
  for (const CsvColumn& column : columns) {
    const auto slot = slot_of(column.name, column.place);
    if (!slot) {
      throw Error("S002", column.place,
                  fmt::format("the column {:?} is none of a load history",
                              column.name.substr(0, 80)),
                  "Titles are time, NAME.force_x, NAME.moment_x, "
                  "GROUP.pressure, acceleration_x, angular_velocity_x, "
                  "angular_acceleration_x and orientation_w, each with its "
                  "unit in brackets: rename the column or take it out.");
    }
    *slot->index = static_cast<int>(factors.size());
    factors.push_back(factor_of(column, slot->dimension));
  }
  if (time_ < 0) {
    throw Error("S003", file.string() + ":1:1", "lacks the column \"time\"",
                "Give one, e.g. \"time [s]\".");
  }
  require_whole_orientation(file.string() + ":1:1");
  values_.resize(static_cast<Eigen::Index>(rows.size()) - 1,
                 static_cast<Eigen::Index>(columns.size()));
  for (std::size_t r = 1; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      values_(static_cast<Eigen::Index>(r) - 1, static_cast<Eigen::Index>(c)) =
          factors[c] * number_of(rows[r][c]);
    }
    places_.push_back(rows[r].front().place);
  }
  require_rising_times();
  if (has_orientation()) {
    require_unit_length();
    require_spin_where_turning();
  }
}

void LoadTable::require_whole_orientation(const std::string& place) const {
  const auto given = std::ranges::count_if(orientation_, [](int column) {
    return column >= 0;
  });
  if (given == 0 || given == std::ssize(orientation_)) return;
  throw Error("S003", place, "lacks columns of the orientation",
              "Give orientation_w, _x, _y and _z, or none of them.");
}

void LoadTable::require_rising_times() const {
  for (std::size_t r = 1; r < rows(); ++r) {
    if (time(r) >= time(r - 1)) continue;
    throw Error("S006", places_[r],
                fmt::format("time falls from {:.9g} s to {:.9g} s", time(r - 1),
                            time(r)),
                "Sort the rows by time; equal times are a step.");
  }
}

void LoadTable::require_unit_length() const {
  constexpr double kOff = 1e-3;
  for (std::size_t r = 0; r < rows(); ++r) {
    Vector3d axis;
    for (Eigen::Index i = 0; i < 3; ++i) {
      axis[i] = value(r, orientation_.at(static_cast<std::size_t>(i) + 1));
    }
    const double length = std::hypot(value(r, orientation_[0]), axis.norm());
    if (std::abs(length - 1.0) <= kOff) continue;
    throw Error("S006", places_[r],
                fmt::format("the orientation has length {:.6g}", length),
                "Give unit quaternions, the real part as orientation_w.");
  }
}

void LoadTable::require_spin_where_turning() const {
  constexpr double kTurned = 2e-3;  // [rad]: digits of a written quaternion
  const Eigen::Quaterniond start = orientation(0);
  // Component about which it turned without a column; nothing: none.
  const auto missing =
      [&](const Eigen::Quaterniond& turn) -> std::optional<std::size_t> {
    for (std::size_t k = 0; k < 3; ++k) {
      const double turned =
          2.0 * std::abs(turn.vec()[static_cast<Eigen::Index>(k)]);
      if (turned > kTurned && omega_.at(k) < 0) return k;
    }
    return std::nullopt;
  };
  for (std::size_t r = 1; r < rows(); ++r) {
    const Eigen::Quaterniond now = orientation(r);
    // In the world's frame and in the part's: the vectors may be of either.
    const auto in_world = missing(now * start.conjugate());
    if (!in_world || !missing(start.conjugate() * now)) continue;
    throw Error("S003", places_[r],
                fmt::format("the part has turned about {}, but the file has no "
                            "angular_velocity_{}",
                            "xyz"[*in_world], "xyz"[*in_world]),
                "Give the columns angular_velocity_x, _y and _z, for spinning "
                "loads a part; zeros, if it turns so slowly that it does not.");
  }
}

double LoadTable::value(std::size_t row, int column) const {
  return column < 0 ? 0.0 : values_(static_cast<Eigen::Index>(row), column);
}

Vector3d LoadTable::vector(std::size_t row,
                           const VectorColumns& columns) const {
  return {value(row, columns[0]), value(row, columns[1]),
          value(row, columns[2])};
}

Vector3d LoadTable::acceleration(std::size_t row) const {
  return vector(row, acceleration_);
}

Vector3d LoadTable::angular_velocity(std::size_t row) const {
  return vector(row, omega_);
}

Vector3d LoadTable::angular_acceleration(std::size_t row) const {
  return vector(row, alpha_);
}

Eigen::Quaterniond LoadTable::orientation(std::size_t row) const {
  return Eigen::Quaterniond(
             value(row, orientation_[0]), value(row, orientation_[1]),
             value(row, orientation_[2]), value(row, orientation_[3]))
      .normalized();
}

}  // namespace clevis::scene
