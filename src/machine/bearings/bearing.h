#pragma once

#include <optional>
#include <string>
#include <vector>

#include "part/verdict.h"

namespace clevis::machine {

enum class BearingKind { kBall, kRoller };

/// Factors of the axial load in an equivalent load: X F_r + Y F_a where
/// F_a / F_r > threshold, else F_r.
struct AxialFactors {
  double X = 1.0, Y = 0.0;
  double threshold{};  ///< e of the catalogue [1]
};

/// A rolling bearing in a joint that turns, as its catalogue has it.
struct BearingDefinition {
  std::string name;
  int joint{};  ///< index into MechanismDefinition::joints
  BearingKind kind{};
  double dynamic_rating{};  ///< C [N]
  double static_rating{};   ///< C0 [N]
  /// Without: the bearing is taken for one of radial loads alone.
  std::optional<AxialFactors> dynamic_factors, static_factors;
  double service_factor = 1.0;        ///< on the dynamic load [1]
  std::optional<double> life_wanted;  ///< [s]
  double static_safety_wanted = 1.0;
  /// 0: not given. Only the width is used, to judge tilting moments.
  double bore{}, outer_diameter{}, width{};  ///< [m]
  std::string place;                         ///< file:line:column
};

/// Loads and speed of the bearing at an instant.
struct BearingInstant {
  double t{};          ///< [s]
  double radial{};     ///< F_r [N]
  double axial{};      ///< |F_a| [N]
  double tilt{};       ///< moment across the axis [N m]
  double speed{};      ///< of the inner against the outer ring [rad/s]
  bool unique = true;  ///< false where redundancy leaves the load open
  /// Of the inner against the outer ring, within a turn; nothing: not known
  /// [rad].
  std::optional<double> angle = std::nullopt;
};

/// A remark by its code in the catalogue of diagnostics.
struct BearingWarning {
  std::string code, text;
};

/// Loads, life and static safety of a bearing over one run of the motion, its
/// cycle. A life is absent where it has no bound: no load, or no turning.
struct BearingResult {
  std::string name;
  int joint{};
  BearingKind kind{};
  double dynamic_rating{}, static_rating{};  ///< C, C0 [N]

  double mean_load{};                  ///< P_m, over the travelled angle [N]
  double peak_load{};                  ///< largest dynamic equivalent load [N]
  double static_load{};                ///< P0, largest over the motion [N]
  double static_load_at{};             ///< [s]
  double peak_radial{}, peak_axial{};  ///< [N]
  double peak_tilt{};                  ///< [N m]

  double duration{};    ///< of a cycle [s]
  double travel{};      ///< angle travelled in a cycle [rad]
  double swing{};       ///< between the extreme angles [rad]
  double mean_speed{};  ///< travel / duration [rad/s]

  std::optional<double> life;          ///< L10 [revolutions]
  std::optional<double> life_cycles;   ///< [cycles]
  std::optional<double> life_seconds;  ///< [s]
  /// Relative change of P_m, travel and L10 when every second instant is left
  /// out: bounds what finer sampling still changes.
  double mean_load_error{}, travel_error{}, life_error{};

  std::optional<double> static_safety;  ///< C0 / P0; absent: no load
  double static_safety_wanted{};
  std::optional<double> life_wanted;  ///< [s]

  part::Verdict verdict{};
  std::string why;  ///< unless it passes
  std::vector<BearingWarning> warnings;
};

/// p of L10 = (C/P)^p: 3 for balls, 10/3 for rollers ([ISO281]).
double life_exponent(BearingKind kind);

/// "ball", "roller".
const char* name_of(BearingKind kind);

/// P = K (X F_r + Y F_a) ([ISO281]) with the service factor K [N].
/// @pre radial, axial >= 0.
double dynamic_equivalent(const BearingDefinition& bearing, double radial,
                          double axial);

/// P0 = max(F_r, X0 F_r + Y0 F_a) ([ISO76]), without the service factor [N].
double static_equivalent(const BearingDefinition& bearing, double radial,
                         double axial);

}  // namespace clevis::machine
