#pragma once

#include "dynamics/strike/strike_run.h"
#include "dynamics/struck_body/struck_body.h"
#include "loads/history/strike.h"

namespace clevis::dynamics {

/// One period of the striker on the springs of contact and body, and one of the
/// body's first vibration; or the strike's own duration [s].
/// @param compliance    static, of the body at its contact [m/N].
/// @param first_square  ω² of its first vibration [1/s²].
double strike_duration(const loads::Strike& strike, double compliance,
                       double first_square);

/// Steps per sample so that the striker alone on its contact is resolved.
/// @param duration  of all samples [s].
int contact_stride(const loads::Strike& strike, double duration, int samples);

/// Whether the steps of `run` carry the rise of the contact force. Longer ones
/// keep the energy too, and impulse and deflection may look settled, but waves
/// in the body ring with up to 20 % more stress: of the direct route also
/// because the midpoint rule delays what oscillates with ω by ω T (ω h)²/12 in
/// all.
bool carries_rise(const StruckBody& body, const loads::Strike& strike,
                  const StrikeRun& run, int steps, bool is_direct);

/// Rise time of the contact force against a body initially at rest [s].
/// Of a rod it is Z/k with Z = A √(E ρ), of a light striker √(2 m/k).
/// @param longest  duration that is searched [s].
double rise_time(StruckBody& body, const loads::Strike& strike, double longest);

/// The last of the runs with ever halved steps.
struct Refined {
  StrikeRun run;
  double error{};  ///< estimated, of what `difference` compares [1]
  int steps{};     ///< of the last run
  int all_steps{};
  bool settled = false;
};

struct StepPlan {
  double tolerance{};       ///< of the error [1]
  double duration{};        ///< [s]
  int samples{}, stride{};  ///< of the first run
  int most_steps{};
  bool carry_rise = true;  ///< go on until the steps do
  bool is_direct = false;
};

/// Runs with ever halved steps until two of them agree. Where the change falls
/// by f with the last halving, 1/(f − 1) of it is left, f = 4 at most: of
/// steps that are still too long it falls by less.
Refined refine_steps(StruckBody& body, const loads::Strike& strike,
                     const StepPlan& plan);

}  // namespace clevis::dynamics
