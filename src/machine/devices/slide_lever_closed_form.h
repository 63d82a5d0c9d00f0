#pragma once

#include <Eigen/Core>

namespace clevis::machine {

/// Form of the equations of [LandingGear] (docs/theory.md, "Slide-lever
/// mechanism").
///
/// Published, (2.9)–(2.16): y_C = l5 + l2 sin q4 + l4 sin q7, which takes q7
/// as an angle against the clock and breaks the rigid link DCE. Corrected:
/// the direction of EC is −q7, so that l4 sin q7 changes its sign.
enum class SlideLeverForm { kPublished, kCorrected };

/// The landing gear's closed form: origin at A, D = (0, AD), F on the −x side.
struct SlideLever {
  double FD{}, ED{}, DC{}, EC{}, AD{}, DD1{};  ///< [m]
};

/// Angles [rad] and point C for one cylinder length.
struct SlideLeverPosition {
  double q1{};                                  ///< FDE (2.2)
  double q2{};                                  ///< inclination of FD (2.3)
  double q3{};                                  ///< inclination of DE (2.4)
  double q4{};                                  ///< (2.10)
  double q5{};                                  ///< DEC (2.14)
  double q7{};                                  ///< (2.12)
  Eigen::Vector2d C = Eigen::Vector2d::Zero();  ///< (2.9) [m]
  double DC{};  ///< distance of C from D, to be the length of the link [m]
  /// d(C)/d(q4, q7), the matrix of (2.16) [m].
  Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
  /// d(C)/d(l_x) with q4' = −q3', q7' = q3' [1].
  Eigen::Vector2d C_rate = Eigen::Vector2d::Zero();
};

/// Equations (2.1)–(2.16) at cylinder length l_x [m].
/// @pre |FD − ED| < l_x < FD + ED, DD1 <= FD; asserted.
SlideLeverPosition slide_lever_position(const SlideLever& lever, double l_x,
                                        SlideLeverForm form);

}  // namespace clevis::machine
