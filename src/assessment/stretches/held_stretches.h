#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "assessment/stretches/excited_modes.h"
#include "assessment/stretches/travelling_vibration.h"
#include "assessment/stretches/vibration_times.h"
#include "elasticity/vibration/eigenmodes.h"

namespace clevis::assessment {

/// Stretches of a motion through which a part is held and weighed alike.
struct HeldStretch {
  double hold_time{};  ///< at which they hold it as they do there [s]
  std::vector<VibrationWindow> windows;
  /// Slides pass where loads excite the part: it may swing so much farther than
  /// at rest, which one place in each stretch does not tell; 0: they do not
  /// [1].
  double swept = 0.0;
};

/// Instants of a motion at which the mechanism holds a part alike.
struct HeldMeanwhile {
  LoadSet motion;
  double period{};  ///< longest that its loads excite; none: of the first [s]
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
  /// Longest first period that the part has as it is held over the motion [s].
  double first_period(std::size_t set);
  /// Its lowest frequencies and what bodies that spin on it move them to, at
  /// the instant when they spin most; none where they do not.
  const std::vector<elasticity::SeatShapes::Moved>& moved_by_spin(
      std::size_t set) {
    return motion(set).moved;
  }
  /// By ways in which the part is held over the motion; none: it has but one.
  std::vector<HeldMeanwhile> meanwhile(std::size_t set);
  /// What lies in windows of followed_loads(), by ways in which the mechanism
  /// holds and weighs the part, and places of its slides, that leave like
  /// vibrations to its loads; of such instants that counts at which the loads
  /// meanwhile excite most. One, at the history's own hold_time, where these do
  /// not change. Each has an instant of the loads in its windows.
  /// @param driven  rising, not empty.
  std::vector<HeldStretch> stretches(
      std::size_t set, const std::vector<VibrationWindow>& driven);
  /// The vibration of a part that the mechanism holds and weighs otherwise from
  /// time to time, through all of the motion; nothing where that cannot be
  /// followed, or does not differ from what its stretches tell.
  /// @param stretches  of stretches().
  std::optional<TravellingVibration> followed(
      std::size_t set, const std::vector<HeldStretch>& stretches);

 private:
  struct Motion {
    explicit Motion(LoadSet followed) : loads(std::move(followed)) {}
    // The solvers refer to the loads.
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;

    LoadSet loads;  ///< followed_loads()
    std::vector<elasticity::FirstPeriods<3>> solvers = {};
    std::vector<HeldModes> modes = {};  ///< of each instant; empty: as one
    std::optional<loads::SpreadSeats> seats = {};  ///< of these, as the shapes
    std::optional<elasticity::SeatShapes> shapes = {};
    bool travels = false;  ///< on slides
    std::vector<elasticity::SeatShapes::Moved> moved = {};
    double longest{};  ///< HeldMotions::first_period()
  };
  using Instants = std::vector<std::size_t>;  ///< of a motion
  Motion& motion(std::size_t set);
  /// How the part's seats are held, sprung, weighed and spun, and the modes
  /// that this leaves.
  void look_at_seats(Motion& motion) const;
  /// As history.hold(), with springs where they count.
  static loads::SeatHold hold_at_instant(const Motion& motion,
                                         std::size_t instant);
  void make_solvers(Motion& motion) const;
  /// First period as the part is held at a time [s].
  double period_held(Motion& motion, double time) const;

  const PartJob& job_;
  std::vector<std::optional<Motion>> motions_;
};

}  // namespace clevis::assessment
