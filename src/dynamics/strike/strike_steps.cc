#include "dynamics/strike/strike_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "dynamics/struck_body/contact_law.h"

namespace clevis::dynamics {
namespace {

double kinetic_energy(const loads::Strike& strike) {
  return 0.5 * strike.mass * strike.speed * strike.speed;
}

/// Approach under the constant force alone [m].
double pressed_in(const loads::Strike& strike) {
  return std::pow(strike.force / strike.contact.stiffness,
                  1.0 / strike.contact.exponent);
}

/// Stiffness of the contact where it is pressed most [N/m].
double stiffest(const loads::Strike& strike) {
  const double approach =
      std::max(head_on(strike.contact, kinetic_energy(strike)).approach,
               pressed_in(strike));
  return ContactLaw(strike.contact).slope(approach);
}

/// Remaining error of a geometric sequence, by its last two changes.
double remaining(double change, std::optional<double> before) {
  constexpr double kSecondOrder = 4.0, kSlowest = 1.5;
  if (!before || !(change > 0.0)) return change;
  const double falls = std::clamp(*before / change, kSlowest, kSecondOrder);
  return change / (falls - 1.0);
}

}  // namespace

double strike_duration(const loads::Strike& strike, double compliance,
                       double first_square) {
  if (strike.duration) return *strike.duration;
  const double contact =
      strike.speed > 0.0
          ? 1.0 / head_on(strike.contact, kinetic_energy(strike)).stiffness
      : strike.contact.exponent == 1.0 ? 1.0 / strike.contact.stiffness
                                       : pressed_in(strike) / strike.force;
  return 2.0 * std::numbers::pi *
         (std::sqrt(strike.mass * (compliance + contact)) +
          1.0 / std::sqrt(first_square));
}

int contact_stride(const loads::Strike& strike, double duration, int samples) {
  constexpr double kStepsPerContact = 16.0;
  const double energy = kinetic_energy(strike);
  if (!(energy > 0.0)) return 1;
  const double contact =
      std::numbers::pi *
      std::sqrt(strike.mass / head_on(strike.contact, energy).stiffness);
  const double steps = duration / contact * kStepsPerContact / samples;
  return static_cast<int>(
      std::exp2(std::ceil(std::log2(std::clamp(steps, 1.0, 4096.0)))));
}

bool carries_rise(const StruckBody& body, const loads::Strike& strike,
                  const StrikeRun& run, int steps, bool is_direct) {
  constexpr double kResolved = 0.1, kDelay = 0.1;
  // what the contact force changes by its own doing within one step
  const double change =
      stiffest(strike) *
      (body.compliance() + run.step * run.step / (2.0 * strike.mass));
  return change < kResolved &&
         (!is_direct || std::pow(change, 3) * steps / 12.0 < kDelay);
}

double rise_time(StruckBody& body, const loads::Strike& strike,
                 double longest) {
  constexpr double kShortest = 1e-7, kExact = 1.01;
  const double stiffness = stiffest(strike);
  double low = kShortest * longest, high = longest;
  while (high > kExact * low) {
    const double time = std::sqrt(low * high);
    body.set_step(time);
    const double turned =
        stiffness * (body.compliance() + time * time / (2.0 * strike.mass));
    (turned > 1.0 ? high : low) = time;
  }
  return high;
}

Refined refine_steps(StruckBody& body, const loads::Strike& strike,
                     const StepPlan& plan) {
  Refined result;
  std::optional<StrikeRun> before;
  std::optional<double> change_before;
  for (int stride = plan.stride;; stride *= 2) {
    StrikeRun run =
        run_strike(body, strike, plan.duration, plan.samples, stride);
    result.steps = plan.samples * stride;
    result.all_steps += result.steps;
    if (before) {
      const double change = difference(*before, run);
      result.error = remaining(change, change_before);
      change_before = change;
    }
    result.settled =
        before && result.error < 0.5 * plan.tolerance &&
        (!plan.carry_rise ||
         carries_rise(body, strike, run, result.steps, plan.is_direct));
    before = std::move(run);
    if (result.settled || 2 * result.steps > plan.most_steps) break;
  }
  result.run = std::move(*before);
  return result;
}

}  // namespace clevis::dynamics
