#include "mechanism/driven_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanism/load_list.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// The shortest time between instants, over that of the uniform ones.
constexpr double kShortest = 1.0 / 512.0;
// Motions that drives fix are smooth but for events: their uniform instants
// are finer than an integrated motion's, whose impacts may lie between two.
constexpr double kCoarseness = 10.0;

/// Time of the vertex of the parabola through three points; that of the
/// middle one if they lie on a line.
double vertex(const std::array<double, 3>& t, const std::array<double, 3>& v) {
  const double left = (v[1] - v[0]) / (t[1] - t[0]);
  const double right = (v[2] - v[1]) / (t[2] - t[1]);
  const double curvature = (right - left) / (t[2] - t[0]);
  if (!(curvature < 0.0)) return t[1];
  const double at = 0.5 * (t[0] + t[1]) - 0.5 * left / curvature;
  return std::clamp(at, t[0], t[2]);
}

struct Lists {
  explicit Lists(const Motion& motion) : list(motion.instants.front()) {
    for (const Instant& instant : motion.instants) {
      loads.emplace_back();
      squares.emplace_back();
      list.get(instant, loads.back());
      list.squares(loads.back(), squares.back());
      if (instant.is_change_point) squares.back().setZero();
    }
  }
  VectorXd largest() const {
    VectorXd result = VectorXd::Zero(list.vectors());
    for (const VectorXd& s : squares) result = result.cwiseMax(s);
    return result;
  }

  LoadList list;
  std::vector<VectorXd> loads, squares;
};

/// Towards a change point rigid reactions have no bound: no instant there is
/// the largest.
bool is_beside_change_point(const Motion& motion, double from, double to,
                            double spacing) {
  return std::ranges::any_of(motion.change_points, [&](const ChangePoint& p) {
    return from <= p.t_after + spacing && to >= p.t_before - spacing;
  });
}

void add_vertices(const Motion& motion, const Lists& lists, double spacing,
                  std::vector<double>& wanted) {
  const auto& instants = motion.instants;
  for (Index v = 0; v < lists.list.vectors(); ++v) {
    std::size_t top = 0;
    for (std::size_t i = 1; i < instants.size(); ++i) {
      if (lists.squares[i][v] > lists.squares[top][v]) top = i;
    }
    if (top == 0 || top + 1 == instants.size() ||
        is_beside_change_point(motion, instants[top - 1].t, instants[top + 1].t,
                               spacing)) {
      continue;
    }
    const double at =
        vertex({instants[top - 1].t, instants[top].t, instants[top + 1].t},
               {lists.squares[top - 1][v], lists.squares[top][v],
                lists.squares[top + 1][v]});
    const bool is_known =
        std::min({at - instants[top - 1].t, std::abs(at - instants[top].t),
                  instants[top + 1].t - at}) < kShortest * spacing;
    if (!is_known) wanted.push_back(at);
  }
}

}  // namespace

std::vector<double> uniform_times(const SimulationSettings& settings) {
  std::vector<double> times;
  for (int i = 0; i + 1 < settings.instants; ++i) {
    times.push_back(settings.duration * i / (settings.instants - 1));
  }
  times.push_back(settings.duration);
  return times;
}

void add_times(const std::vector<double>& more, double duration,
               std::vector<double>& times) {
  const double apart = kApart * duration;
  for (const double t : more) {
    const auto next = std::ranges::lower_bound(times, t);
    const bool is_known = (next != times.end() && *next - t < apart) ||
                          (next != times.begin() && t - *(next - 1) < apart);
    if (!is_known) times.insert(next, t);
  }
}

std::vector<double> sides_of_bends(const MechanismDefinition& definition,
                                   double duration) {
  std::vector<double> bends;
  for (const DriveDefinition& drive : definition.drives) {
    if (drive.law == DriveLaw::kConstant) continue;
    bends.push_back(drive.start);
    bends.push_back(drive.start + drive.duration);
    if (!drive.table.times.empty()) {
      bends.push_back(drive.start + drive.table.times.front());
      bends.push_back(drive.start + drive.table.times.back());
    }
  }
  std::vector<double> sides;
  const double side = 0.5 * kSides * duration;
  for (const double t : bends) {
    if (t <= 2.0 * side || t >= duration - 2.0 * side) continue;
    sides.push_back(t - side);
    sides.push_back(t + side);
  }
  return sides;
}

bool changes_mode(const MechanismDefinition& definition, const Instant& a,
                  const Instant& b) {
  for (std::size_t k = 0; k < definition.elements.size(); ++k) {
    const ElementState& before = a.elements[k];
    const ElementState& after = b.elements[k];
    if (contact_law(definition.elements[k]) != nullptr &&
        (before.effort == 0.0) != (after.effort == 0.0)) {
      return true;
    }
    if (switched_friction(definition.elements[k]) != nullptr &&
        before.rate * after.rate < 0.0) {
      return true;
    }
  }
  return false;
}

std::vector<double> wanted_times(const Motion& motion, double spacing) {
  std::vector<double> wanted;
  const auto& instants = motion.instants;
  const Lists lists(motion);
  LoadChange change(lists.list, lists.largest(), kCoarseness);
  const double shortest = kShortest * spacing;
  for (std::size_t i = 1; i < instants.size(); ++i) {
    const double a = instants[i - 1].t, b = instants[i].t;
    if (b - a <= shortest || is_beside_change_point(motion, a, b, spacing)) {
      continue;
    }
    if (change.is_large(lists.loads[i - 1], lists.loads[i])) {
      wanted.push_back(0.5 * (a + b));
    }
  }
  if (wanted.empty()) add_vertices(motion, lists, spacing, wanted);
  return wanted;
}

}  // namespace clevis::mechanism
