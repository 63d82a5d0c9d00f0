#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "assessment/stretches/excited_modes.h"
#include "assessment/stretches/vibration_times.h"
#include "elasticity/vibration/eigenmodes.h"

namespace clevis::assessment {

/// Stretches of a motion through which a part is held and weighed alike.
struct HeldStretch {
  double hold_time{};  ///< at which they hold it as they do there [s]
  std::vector<VibrationWindow> windows;
};

/// How the mechanism holds a part through the motions of its load sets; worked
/// out when it is asked for first.
class HeldMotions {
 public:
  /// @param job  outlives the object.
  explicit HeldMotions(const PartJob& job)
      : job_(job), motions_(job.load_sets.size()) {}

  /// The load set's followed_loads(), which say whether springs hold the part.
  const LoadSet& loads(std::size_t set) { return motion(set).loads; }
  /// Longest first period that the part has with its slide at either end of its
  /// way or in the middle, or as bodies about it stand [s].
  double first_period(std::size_t set);
  /// Its lowest frequencies and what bodies that spin on it move them to, at
  /// the instant when they spin most; none where they do not.
  const std::vector<elasticity::SeatShapes::Moved>& moved_by_spin(
      std::size_t set) {
    return motion(set).moved;
  }
  /// What lies in windows of followed_loads(), by places of the slide between
  /// which the first period is like, or else by ways in which the mechanism
  /// holds and weighs the part that leave like vibrations to its loads; of such
  /// instants that counts at which the loads meanwhile excite most. One, at the
  /// history's own hold_time, where these do not change. Each has an instant of
  /// the loads in its windows.
  /// @param driven  rising, not empty.
  std::vector<HeldStretch> stretches(
      std::size_t set, const std::vector<VibrationWindow>& driven);

 private:
  struct Motion {
    explicit Motion(LoadSet followed) : loads(std::move(followed)) {}
    // The solvers refer to the loads.
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;

    LoadSet loads;  ///< followed_loads()
    std::vector<elasticity::FirstPeriods<3>> solvers = {};
    /// slide_way() [m]; empty: no slide, or as one.
    std::vector<double> places = {};
    double low{}, high{};  ///< of them
    /// Of each instant, without a slide; empty: as one.
    std::vector<HeldModes> modes = {};
    std::vector<elasticity::SeatShapes::Moved> moved = {};
    std::map<long long, double> periods = {};  ///< first, by place [s]
    double longest{};                          ///< HeldMotions::first_period()
  };
  using Instants = std::vector<std::size_t>;  ///< of a motion
  /// Periods by which an instant is looked at [s].
  using PeriodsOf = std::function<Eigen::VectorXd(std::size_t)>;

  Motion& motion(std::size_t set);
  /// How the part's seats are held, sprung, weighed and spun; without a slide
  /// the modes that this leaves, too.
  void look_at_seats(Motion& motion) const;
  void make_solvers(Motion& motion) const;
  /// First period as the part is held at a time [s].
  double period_held(Motion& motion, double time) const;
  double period_at(Motion& motion, std::size_t instant) const;
  void split(Motion& motion, const Instants& at, int depth,
             const std::vector<VibrationWindow>& driven,
             std::vector<HeldStretch>& found) const;
  /// @param at  by place. @return first period, linear between three places.
  PeriodsOf periods_by_place(Motion& motion, const Instants& at) const;
  HeldStretch stretch_of(const Motion& motion, const Instants& at,
                         const std::vector<VibrationWindow>& driven,
                         const PeriodsOf& periods) const;
  std::size_t most_excited(const Motion& motion, const Instants& at,
                           const std::vector<VibrationWindow>& windows,
                           const PeriodsOf& periods) const;

  const PartJob& job_;
  std::vector<std::optional<Motion>> motions_;
};

/// What lies in both, rising. @param a, b  rising.
std::vector<VibrationWindow> in_both(const std::vector<VibrationWindow>& a,
                                     const std::vector<VibrationWindow>& b);

}  // namespace clevis::assessment
