#include "scene/force_elements/read_impedance.h"

#include <array>
#include <vector>

#include <fmt/format.h>

#include "scene/element_base/line_source.h"
#include "scene/text/times.h"

namespace clevis::scene {
namespace {

/// Splines through `targets` at `times`, by axis.
std::array<numerics::CubicSpline, 3> read_path(StrictTable& table) {
  if (!table.has("targets")) {
    throw table.refusal("S003", "lacks the key \"target\" or \"targets\"",
                        "Give a point, or times and targets.");
  }
  const std::vector<double> times = increasing_times(table["times"], 2);
  const Value targets = table["targets"];
  std::array<std::vector<double>, 3> points;
  for (const Value& target : targets.elements()) {
    const Eigen::Vector3d p = target.vector(Dimension::kLength);
    for (int k = 0; k < 3; ++k) {
      points[static_cast<std::size_t>(k)].push_back(p[k]);
    }
  }
  if (points[0].size() != times.size()) {
    throw targets.refusal("S010",
                          fmt::format("has {} entries for {} times",
                                      points[0].size(), times.size()),
                          "Give one point per time.");
  }
  const numerics::SplineEnds ends = read_spline_ends(table);
  std::array<numerics::CubicSpline, 3> path;
  for (std::size_t k = 0; k < 3; ++k) {
    path[k] = numerics::interpolating_spline(times, points[k], ends);
  }
  return path;
}

}  // namespace

mechanism::ForceElement read_impedance(StrictTable& table, const Names& names) {
  mechanism::ImpedanceElement impedance;
  const Value body = table["body"];
  impedance.point.body = names.bodies.find(body.name(), body);
  impedance.point.p_L = table["point"].vector(Dimension::kLength);
  if (table.has("target")) {
    impedance.target_W = table["target"].vector(Dimension::kLength);
  } else {
    impedance.path_W = read_path(table);
  }
  impedance.stiffness =
      plausible_stiffness_or_zero(table["stiffness"], Dimension::kStiffness);
  impedance.damping = not_negative(table["damping"], Dimension::kDamping);
  if (const auto of = table.find("damping_of")) {
    impedance.damps_absolute =
        of->choice<bool>({{"relative", false}, {"absolute", true}});
  }
  return impedance;
}

}  // namespace clevis::scene
