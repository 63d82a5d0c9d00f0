#pragma once

#include <string_view>

namespace clevis::report {

/// How a quantity of a result is held against its baseline.
enum class Treatment {
  kCompare,  ///< a change above the tolerance is a regression
  kNote,     ///< a change is told, and is no regression
  kIgnore,   ///< not looked at
};

/// Allowed change = relative |baseline| + absolute.
struct Tolerance {
  Treatment treatment{};
  double relative{};  ///< [1]
  double absolute{};  ///< in the unit of the quantity

  bool operator==(const Tolerance&) const = default;
};

/// The default tolerance of a quantity and why it is that.
struct Rule {
  Tolerance tolerance;
  std::string_view reason;
};

/// Tolerance that a regression exceeds: relative [1], absolute in the units of
/// the quantity.
constexpr Tolerance compare_within(double relative, double absolute) {
  return {Treatment::kCompare, relative, absolute};
}

/// Change beyond which a note is made, in the units of the quantity.
constexpr Tolerance note_beyond(double absolute) {
  return {Treatment::kNote, 0.0, absolute};
}

/// Texts and counts that must not change.
constexpr Rule exact(std::string_view reason) {
  return {compare_within(0.0, 0.0), reason};
}

// Rules that several quantities share. The absolute parts only stand for zero:
// far below what anybody reads, far above round-off.

/// Of verdicts.
inline constexpr Rule kVerdictRule = exact("a verdict is a word");

/// Of reactions and what follows from them in closed form; `absolute` in the
/// units of the quantity.
constexpr Rule like_reactions(double absolute) {
  return {compare_within(1e-6, absolute), "as peak_force"};
}

/// Of the stress that parts are judged by.
inline constexpr Rule kPeakRule = {
    compare_within(2e-3, 1e-6),
    "a fifth of the 1 % that a check aims at, so a change of 0.5 % is caught; "
    "solver and libraries move it by less than 1e-6"};

/// Of other results of finite elements; `absolute` in the units of the
/// quantity.
constexpr Rule like_the_peak(double absolute) {
  return {compare_within(2e-3, absolute), "as peak_von_mises"};
}

inline constexpr Rule kStressRule = like_the_peak(1e-6);     // [MPa]
inline constexpr Rule kLengthRule = like_the_peak(1e-9);     // [mm]
inline constexpr Rule kPureNumberRule = like_the_peak(0.0);  // [1]

inline constexpr Rule kModelRule = {note_beyond(0.0),
                                    "another model may reach the same value"};
inline constexpr Rule kPlaceRule = {
    note_beyond(0.05),
    "symmetric parts have equal peaks at several places, and round-off "
    "chooses; where the peak is single, its value moves too"};
inline constexpr Rule kInstantRule = {note_beyond(1e-9), "as peak_position"};

}  // namespace clevis::report
