#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

/// Motions known to many digits, and how far what a program makes of them is
/// off: the same for every program.
namespace clevis::benchmarks {

/// What a program says of one instant. What it does not say is < 0; energy:
/// NaN.
struct Sample {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< Course::known [m]
  double energy = NAN;                              ///< [J], up to a constant
  double gap = -1.0;                                ///< of closed loops [m]
  double pin = -1.0;                                ///< Course::pin [N]
  double branch =
      -1.0;  ///< distance from the branch, or closed form [rad], [1]
};

struct Course {
  std::string name;
  double duration{};  ///< [s]
  int instants{};     ///< at equal distances, with start and end
  /// Force in the first pin for a position of the point [N]; empty: not known.
  std::function<double(const Eigen::Vector3d&)> pin;
  /// Position of a point at some of the instants [m].
  std::vector<std::pair<int, Eigen::Vector3d>> known = {};
  /// Force in a joint at some of the instants [N].
  std::vector<std::pair<int, double>> known_pin = {};
};

/// A row of reference_points.csv, from which every program takes what is known
/// of its course.
inline void add_point(Course& course, const std::string& row) {
  std::stringstream cells(row);
  std::string name, cell;
  std::getline(cells, name, ',');
  if (name != course.name) return;
  std::array<double, 5> values{};  // t, x, y, z, pin
  values[4] = NAN;
  for (std::size_t k = 0; k < 5 && std::getline(cells, cell, ','); ++k) {
    if (!cell.empty()) values[k] = std::stod(cell);
  }
  const auto i = static_cast<int>(
      std::lround(values[0] / course.duration * (course.instants - 1)));
  course.known.emplace_back(i,
                            Eigen::Vector3d(values[1], values[2], values[3]));
  if (!std::isnan(values[4])) course.known_pin.emplace_back(i, values[4]);
}

inline Course with_points(Course course) {
  std::ifstream file(CLEVIS_REFERENCE_POINTS);
  for (std::string row; std::getline(file, row);) add_point(course, row);
  if (course.known.empty()) {
    throw std::runtime_error("no reference of " + course.name);
  }
  return course;
}

/// Largest over the instants; < 0: not known.
struct TrajectoryErrors {
  double position = -1.0, energy = -1.0, gap = -1.0, reaction = -1.0,
         branch = -1.0;
};

inline TrajectoryErrors errors(const Course& course,
                               const std::vector<Sample>& samples) {
  TrajectoryErrors worst;
  for (const auto& [i, point] : course.known) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    worst.position = std::max(worst.position, (sample.point - point).norm());
  }
  for (const auto& [i, pin] : course.known_pin) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    if (sample.pin < 0.0) continue;
    worst.reaction = std::max(worst.reaction, std::abs(sample.pin - pin));
  }
  for (const Sample& sample : samples) {
    const double change = std::abs(sample.energy - samples[0].energy);
    if (!std::isnan(change)) worst.energy = std::max(worst.energy, change);
    worst.gap = std::max(worst.gap, sample.gap);
    worst.branch = std::max(worst.branch, sample.branch);
    if (course.pin && sample.pin >= 0.0) {
      worst.reaction = std::max(
          worst.reaction, std::abs(sample.pin - course.pin(sample.point)));
    }
  }
  return worst;
}

/// Elliptic functions; tension 3 m g sin(angle below the horizontal).
inline Course pendulum_course() {
  return with_points({"pendulum", 10.0, 11, [](const Eigen::Vector3d& tip) {
                        return 3.0 * 9.81 * std::abs(tip.y());
                      }});
}

/// Force on the first upright bar at the ground. All upright bars lean by θ:
/// 3 θ'' = −3.5 g cos θ, 3 θ'²/2 = 3/2 + 3.5 g (1 − sin θ); a level bar gets
/// half of its weight and inertia across from each end, and along from the
/// balance of moments of the upright bar.
inline double four_bar_pin(const Eigen::Vector3d& tip) {
  const double g = 9.81, c = tip.x(), s = tip.y();
  const double turn = -3.5 / 3.0 * g * c;
  const double square = 1.0 + 7.0 / 3.0 * g * (1.0 - s);
  const double a_x = -s * turn - c * square, a_y = c * turn - s * square;
  const double on_level_y = 0.5 * (a_y + g);
  const double on_level_x = (turn / 3.0 + c * (0.5 * g + on_level_y)) / s;
  return std::hypot(0.5 * a_x + on_level_x, 0.5 * a_y + g + on_level_y);
}

/// Converged; the first top corner.
inline Course four_bar_course() {
  return with_points({"two_window_four_bar", 10.0, 11, four_bar_pin});
}

/// Converged, nine digits; the slider.
inline Course slider_crank_course() {
  return with_points({"spatial_slider_crank", 5.0, 51, {}});
}

/// The sleeve every two seconds (GovernorEquations).
inline Course governor_course() {
  return with_points({"governor", 10.0, 11, {}});
}

/// Start of the fourth bar every second (BricardEquations).
inline Course bricard_course() {
  return with_points({"bricard", 10.0, 11, {}});
}

/// Direction of the crank K1, and the force at E on K3.
inline Course andrews_course() {
  return with_points({"andrews", 0.03, 4, {}});
}

/// Direction of the pole, and the cart (z).
inline Course cart_pole_course() {
  return with_points({"light_cart_pole", 10.0, 11, {}});
}

/// Direction of the crank every second (CrankRockerEquations).
inline Course crank_rocker_course() {
  return with_points({"crank_rocker", 10.0, 11, {}});
}

}  // namespace clevis::benchmarks
