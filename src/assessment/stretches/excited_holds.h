#pragma once

#include <cstddef>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/stretches/excited_modes.h"
#include "assessment/stretches/vibration_times.h"

namespace clevis::assessment {

/// An instant, and what oscillators of its modes answer [1].
struct ExcitedInstant {
  std::size_t instant{};
  double answer{};
};

/// How much the loads of a motion excite oscillators of the modes that a part
/// has as the mechanism holds it from time to time.
class ExcitedHolds {
 public:
  /// @param motion  followed_loads(). @param modes  of each of its instants.
  ///   All outlive the object.
  ExcitedHolds(const PartJob& job, const LoadSet& motion,
               const std::vector<HeldModes>& modes)
      : job_(job), motion_(motion), modes_(modes) {}

  /// Of some instants that which answers most.
  /// @param windows  of the instants. @param loaded  whose loads count.
  ExcitedInstant most_excited(const std::vector<std::size_t>& at,
                              const std::vector<VibrationWindow>& windows,
                              const std::vector<VibrationWindow>& loaded) const;

  /// Largest answer of the modes that an instant has, whose periods change with
  /// the hold [1].
  double swept_answer(std::size_t instant,
                      const std::vector<VibrationWindow>& driven) const;

 private:
  /// Of the instants in some windows alone.
  dynamics::LoadPath loads_within(
      const std::vector<VibrationWindow>& windows) const;

  const PartJob& job_;
  const LoadSet& motion_;
  const std::vector<HeldModes>& modes_;
};

}  // namespace clevis::assessment
