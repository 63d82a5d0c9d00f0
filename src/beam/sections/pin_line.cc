#include "beam/sections/pin_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace clevis::beam {

using Eigen::Vector3d;

namespace {

constexpr int kStationsPerSpan = 25;
// Distance of the first and the last station from the rims, relative to the
// span: a plane that touches a cylinder has no well-defined section.
constexpr double kRimGap = 0.01;
constexpr double kRowTolerance = 0.05;
constexpr double kRoundOff = 1e-9;  // of a span between seats that abut

struct Row {
  Vector3d direction;
  std::vector<std::size_t> seats;
};

// Half the length that a seat's cylinder takes along a line, of a slide what is
// touched [m].
double reach(const loads::LoadHistory& history, std::size_t index,
             const std::vector<loads::GroupGeometry>& groups,
             const Vector3d& direction) {
  const loads::Seat& seat = history.seats[index];
  if (seat.slide && !history.instants.empty() &&
      index < history.instants.front().zones.size()) {
    const loads::ContactZone& zone = history.instants.front().zones[index];
    const double length = zone.high[0] - zone.low[0];
    if (std::isfinite(length)) {
      return 0.5 * length * std::abs(direction.dot(seat.slide->along_L));
    }
  }
  const auto group =
      std::ranges::find(groups, seat.group, &loads::GroupGeometry::name);
  if (group == groups.end() || !group->is_cylinder) return 0.0;
  const part::Bore& c = group->cylinder;
  const double along = std::abs(direction.dot(c.axis_L));
  return 0.5 * along * c.length +
         std::sqrt(std::max(0.0, 1.0 - along * along)) * c.radius;
}

Row row_through(const loads::LoadHistory& history,
                std::vector<std::size_t> seats, const Vector3d& direction) {
  std::ranges::stable_sort(seats, {}, [&](std::size_t i) {
    return history.seats[i].p_LS.dot(direction);
  });
  return {direction, std::move(seats)};
}

// The two seats that are farthest apart.
std::pair<std::size_t, std::size_t> outer_seats(
    const loads::LoadHistory& history) {
  std::pair<std::size_t, std::size_t> outer{0, 0};
  double largest = 0.0;
  for (std::size_t i = 0; i < history.seats.size(); ++i) {
    for (std::size_t j = i + 1; j < history.seats.size(); ++j) {
      const double distance =
          (history.seats[j].p_LS - history.seats[i].p_LS).norm();
      if (distance > largest) {
        largest = distance;
        outer = {i, j};
      }
    }
  }
  return outer;
}

std::vector<Row> rows(const loads::LoadHistory& history) {
  const auto [first, last] = outer_seats(history);
  if (first == last) return {};
  const auto at = [&](std::size_t i) {
    return history.seats[i].p_LS;
  };
  const double length = (at(last) - at(first)).norm();
  const Vector3d direction = (at(last) - at(first)) / length;
  std::vector<std::size_t> all, bearing;
  bool in_a_row = true;
  for (std::size_t i = 0; i < history.seats.size(); ++i) {
    all.push_back(i);
    if (history.seats[i].kind == loads::SeatKind::kBearing) {
      bearing.push_back(i);
    }
    const double off = direction.cross(at(i) - at(first)).norm();
    in_a_row = in_a_row && off <= kRowTolerance * length;
  }
  if (in_a_row) return {row_through(history, all, direction)};
  std::vector<Row> pairs;
  for (std::size_t a = 0; a < bearing.size(); ++a) {
    for (std::size_t b = a + 1; b < bearing.size(); ++b) {
      const Vector3d apart = at(bearing[b]) - at(bearing[a]);
      if (apart.norm() <= kRowTolerance * length) continue;
      pairs.push_back(
          row_through(history, {bearing[a], bearing[b]}, apart.normalized()));
    }
  }
  return pairs;
}

bool passes_a_third_seat(const loads::LoadHistory& history,
                         const std::vector<loads::GroupGeometry>& groups,
                         const Span& span, const Vector3d& point,
                         const Vector3d& direction) {
  for (std::size_t i = 0; i < history.seats.size(); ++i) {
    if (i == span.from || i == span.to) continue;
    const double distance = (history.seats[i].p_LS - point).dot(direction);
    if (std::abs(distance) < reach(history, i, groups, direction)) {
      return true;
    }
  }
  return false;
}

Span build_span(const PartModel& model, const part::MassProperties& mass,
                const std::vector<loads::GroupGeometry>& groups,
                const loads::LoadHistory& history, const Vector3d& direction,
                std::size_t from, std::size_t to) {
  Span span;
  span.from = from;
  span.to = to;
  const Vector3d p_LF = history.seats[from].p_LS;
  span.length = (history.seats[to].p_LS - p_LF).dot(direction);
  const double start = reach(history, from, groups, direction);
  const double end = span.length - reach(history, to, groups, direction);
  if (end - start <= kRoundOff * std::abs(span.length)) return span;
  std::vector<double> wanted, planes;
  for (int k = 0; k < kStationsPerSpan; ++k) {
    const double t =
        kRimGap + (1.0 - 2.0 * kRimGap) * k / (kStationsPerSpan - 1);
    wanted.push_back(start + t * (end - start));
    planes.push_back(p_LF.dot(direction) + wanted.back());
  }
  const std::vector<MassMoments> moments =
      moments_beyond(model.lumps, mass, direction, planes);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const Vector3d point = p_LF + wanted[k] * direction;
    if (passes_a_third_seat(history, groups, span, point, direction)) continue;
    const mesh::Section section = model.section(point, direction);
    if (!(section.area > 0.0)) continue;
    if (k == 0) span.starts_at_seat = true;
    if (k + 1 == wanted.size()) span.ends_at_seat = true;
    span.positions.push_back(wanted[k]);
    span.stations.emplace_back(section, direction, moments[k]);
    span.beyond.push_back(loads_beyond(history, groups, point, direction));
  }
  return span;
}

}  // namespace

std::vector<PinLine> pin_lines(const PartModel& model,
                               const part::MassProperties& mass,
                               const std::vector<loads::GroupGeometry>& groups,
                               const loads::LoadHistory& history) {
  std::vector<PinLine> lines;
  for (Row& row : rows(history)) {
    PinLine line;
    line.direction = row.direction;
    for (std::size_t k = 0; k + 1 < row.seats.size(); ++k) {
      Span span = build_span(model, mass, groups, history, row.direction,
                             row.seats[k], row.seats[k + 1]);
      if (!span.stations.empty()) line.spans.push_back(std::move(span));
    }
    line.seats = std::move(row.seats);
    if (!line.spans.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace clevis::beam
