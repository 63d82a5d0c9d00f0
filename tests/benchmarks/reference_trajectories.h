#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "support/bricard_equations.h"
#include "support/governor_equations.h"

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
  /// Position of a point at some of the instants [m].
  std::vector<std::pair<int, Eigen::Vector3d>> known;
  /// Force in the first pin for a position of the point [N]; empty: not known.
  std::function<double(const Eigen::Vector3d&)> pin;
};

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
  return {"pendulum",
          10.0,
          11,
          {{1, {0.986291751131875, -0.165010853125541, 0.0}},
           {5, {-0.942305435043757, -0.334754338414001, 0.0}},
           {10, {-0.275087462576117, -0.961419205099125, 0.0}}},
          [](const Eigen::Vector3d& tip) {
            return 3.0 * 9.81 * std::abs(tip.y());
          }};
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
  return {"two_window_four_bar",
          10.0,
          11,
          {{1, {-0.195020301949, -0.980799205662, 0.0}},
           {5, {-0.811310461004, -0.584615545351, 0.0}},
           {10, {0.328458111539, 0.944518538179, 0.0}}},
          four_bar_pin};
}

/// Converged, nine digits; the slider.
inline Course slider_crank_course() {
  return {"spatial_slider_crank",
          5.0,
          51,
          {{1, {0.226787189, 0.0, 0.0}},
           {5, {0.184952630, 0.0, 0.0}},
           {10, {0.211721661, 0.0, 0.0}},
           {50, {0.240719574, 0.0, 0.0}}},
          {}};
}

/// Depth of the sleeve every two seconds, by equations of its own.
inline Course governor_course() {
  Course course{"governor", 10.0, 11, {}, {}};
  mechanism::testing::GovernorEquations equations({});
  for (int i = 2; i <= 10; i += 2) {
    equations.advance(2.0, 400000);
    course.known.emplace_back(i, Eigen::Vector3d(0.0, 0.0, -equations.depth()));
  }
  return course;
}

/// Start of the fourth bar every second, by equations of its own.
inline Course bricard_course() {
  Course course{"bricard", 10.0, 11, {}, {}};
  mechanism::testing::BricardEquations equations;
  for (int i = 1; i <= 10; ++i) {
    equations.advance(1.0, 1000);
    course.known.emplace_back(i, equations.corner());
  }
  return course;
}

}  // namespace clevis::benchmarks
