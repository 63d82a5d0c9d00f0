#pragma once

#include <string>

#include "assessment/job/part_result.h"

namespace clevis::assessment {

/// Vibration in one stretch of a motion by the degree below the highest.
struct LowVibration {
  int count{};  ///< shapes that suffice
  double ratio{}, still{};
  double shape_error{}, path_error{};  ///< as of VibrationResult
  std::string group{};                 ///< of the peak
  double deflection{};                 ///< as of VibrationResult

  /// The ratio, with the errors that are its own.
  double most() const { return ratio * (1.0 + shape_error + path_error); }
};

/// Whether a ratio of the fewest shapes [1] is so far below the largest of the
/// stretches before that refining it changes nothing.
bool is_far_below(double ratio, double largest);

/// Whether what the high degree found of one stretch is more than what it may
/// find of another: that changes with the degree as the first does where both
/// peaks lie on one surface, else by up to a tenth more.
/// @param low  of the other. @param first  of the stretch that was found.
bool is_covered(const LowVibration& low, const LowVibration& first,
                const VibrationResult& found);

/// Of two stretches that with the larger peak, with the larger deflection of
/// both.
VibrationResult larger_of(VibrationResult a, VibrationResult b);

}  // namespace clevis::assessment
