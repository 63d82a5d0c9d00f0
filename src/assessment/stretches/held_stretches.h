#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "assessment/job/part_job.h"
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
  /// What lies in windows of followed_loads(), by places of the slide, or else
  /// ways in which other bodies stand, between which the first period is like;
  /// of such places that counts which the loads meanwhile excite most. One, at
  /// the history's own hold_time, where the first period does not change.
  /// Each has an instant of the loads in its windows.
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
    /// slide_way() [m], or without a slide first periods [s]; empty: as one.
    std::vector<double> places = {};
    bool are_periods = false;
    double low{}, high{};  ///< of them
    std::vector<elasticity::SeatShapes::Moved> moved = {};
    std::map<long long, double> periods = {};  ///< first, by place [s]
    double longest{};                          ///< HeldMotions::first_period()
  };
  /// Instants of a motion, by place.
  using Instants = std::vector<std::size_t>;

  Motion& motion(std::size_t set);
  /// How the part's seats are held, sprung, weighed and spun; puts
  /// periods in place of a slide's way that it does not have.
  void look_at_seats(Motion& motion) const;
  void make_solvers(Motion& motion) const;
  /// First period as the part is held at a time [s].
  double period_held(Motion& motion, double time) const;
  double period_at(Motion& motion, std::size_t instant) const;
  void split(Motion& motion, const Instants& at, int depth,
             const std::vector<VibrationWindow>& driven,
             std::vector<HeldStretch>& found) const;
  HeldStretch stretch_of(Motion& motion, const Instants& at,
                         const std::vector<VibrationWindow>& driven) const;
  std::size_t most_excited(Motion& motion, const Instants& at,
                           const std::vector<VibrationWindow>& windows) const;

  const PartJob& job_;
  std::vector<std::optional<Motion>> motions_;
};

/// What lies in both, rising. @param a, b  rising.
std::vector<VibrationWindow> in_both(const std::vector<VibrationWindow>& a,
                                     const std::vector<VibrationWindow>& b);

}  // namespace clevis::assessment
