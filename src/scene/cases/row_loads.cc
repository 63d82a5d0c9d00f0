#include "scene/cases/row_loads.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::scene {
namespace {

using Eigen::Vector3d;
using part::SeriesInstant;

/// Visits the vectors of instants with like seats, one of each at a time.
template <class Visit, class... Instants>
void visit_vectors(const Visit& visit, Instants&... instants) {
  const auto& first = std::get<0>(std::tie(instants...));
  for (std::size_t s = 0; s < first.forces.size(); ++s) {
    visit(instants.forces[s]...);
    visit(instants.moments[s]...);
  }
  visit(instants.acceleration...);
  visit(instants.angular_velocity...);
  visit(instants.angular_acceleration...);
}

double duration(const RowLoads& from, const RowLoads& to) {
  return to.loads.time - from.loads.time;
}

/// By its orientation, the shorter way [rad].
double turn_between(const RowLoads& from, const RowLoads& to) {
  return from.orientation.angularDistance(to.orientation);
}

/// By its angular velocity [rad].
double turn_by_speed(const RowLoads& from, const RowLoads& to) {
  return 0.5 * duration(from, to) *
         (from.loads.angular_velocity.norm() +
          to.loads.angular_velocity.norm());
}

/// Loads that change evenly in the file's frame; the part turns evenly.
/// @param share  of the way [1].
RowLoads between_rows(const RowLoads& from, const RowLoads& to, double share) {
  RowLoads row = from;
  row.loads.is_between_rows = true;
  row.loads.time += share * duration(from, to);
  visit_vectors(
      [&](Vector3d& value, const Vector3d& end) {
        value += share * (end - value);
      },
      row.loads, to.loads);
  for (std::size_t p = 0; p < row.loads.pressures.size(); ++p) {
    double& pressure = row.loads.pressures[p];
    pressure += share * (to.loads.pressures[p] - pressure);
  }
  row.orientation = from.orientation.slerp(share, to.orientation);
  return row;
}

SeriesInstant in_part(const RowLoads& row) {
  SeriesInstant instant = row.loads;
  const Eigen::Matrix3d R_LF(row.orientation.conjugate());
  visit_vectors(
      [&](Vector3d& vector) {
        vector = R_LF * vector;
      },
      instant);
  return instant;
}

/// How many steps each pair of rows needs.
class Steps {
 public:
  Steps(const std::vector<RowLoads>& rows, part::BetweenRows between)
      : is_linear_(between == part::BetweenRows::kLinear) {
    for (const RowLoads& row : rows) {
      std::size_t k = 0;
      visit_vectors(
          [&](const Vector3d& vector) {
            if (k == largest_.size()) largest_.push_back(0.0);
            largest_[k] = std::max(largest_[k], vector.norm());
            ++k;
          },
          row.loads);
      spin_ = std::max(spin_, row.loads.angular_velocity.norm());
    }
  }

  int between(const RowLoads& from, const RowLoads& to) const {
    // Off the straight line, of the loads: an arc is by turn²/8, a vector that
    // changes as it turns by turn × change / 4, a square by change² / 4.
    constexpr double kOff = 1e-4, kTurn = 1.0 / 32.0, kSpin = 0.02;
    constexpr int kFewest = 12;  // for stress::time_sampling_error
    if (!(duration(from, to) > 0.0)) return 1;
    const double turn = turn_between(from, to);
    const double spun =
        (to.loads.angular_velocity - from.loads.angular_velocity).norm();
    const bool is_straight = turn <= kTurn &&
                             0.25 * turn * change(from, to) <= kOff &&
                             !(is_linear_ && spun > kSpin * spin_);
    if (is_straight) return 1;
    return std::max(kFewest, static_cast<int>(std::ceil(turn / kTurn)));
  }

 private:
  /// Largest change of a vector over its own largest [1].
  double change(const RowLoads& from, const RowLoads& to) const {
    double most = 0.0;
    std::size_t k = 0;
    visit_vectors(
        [&](const Vector3d& a, const Vector3d& b) {
          const double largest = largest_[k++];
          if (largest > 0.0) most = std::max(most, (b - a).norm() / largest);
        },
        from.loads, to.loads);
    return most;
  }

  bool is_linear_;
  std::vector<double> largest_;  ///< of each vector
  double spin_ = 0.0;            ///< largest [rad/s]
};

}  // namespace

void require_known_turns(const std::vector<RowLoads>& rows) {
  constexpr double kFarthest = std::numbers::pi / 2.0;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (!(duration(rows[r - 1], rows[r]) > 0.0)) continue;  // a step
    const double turn = turn_between(rows[r - 1], rows[r]);
    const double by_speed = turn_by_speed(rows[r - 1], rows[r]);
    constexpr double kDigits = 1e-6;  // of a written quaternion
    if (std::max(turn, by_speed) < kFarthest - kDigits) continue;
    throw Error(
        "S006", rows[r].place,
        fmt::format("since the row before the part turns by {:.4g} deg{}",
                    std::max(turn, by_speed) * 180.0 / std::numbers::pi,
                    by_speed > turn ? " by its angular velocity" : ""),
        "How loads in the world's frame act on it there is not known: give "
        "rows between which it turns by less than 90 deg, or the loads in the "
        "part's frame.");
  }
}

std::vector<SeriesInstant> instants_in_part(const std::vector<RowLoads>& rows,
                                            part::BetweenRows between) {
  const Steps steps(rows, between);
  std::vector<SeriesInstant> instants;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    instants.push_back(in_part(rows[r]));
    if (r + 1 == rows.size()) break;
    const int count = steps.between(rows[r], rows[r + 1]);
    for (int k = 1; k < count; ++k) {
      const double share = static_cast<double>(k) / count;
      instants.push_back(in_part(between_rows(rows[r], rows[r + 1], share)));
    }
  }
  return instants;
}

}  // namespace clevis::scene
