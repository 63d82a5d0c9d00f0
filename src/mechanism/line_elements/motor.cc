#include "mechanism/line_elements/motor.h"

#include <algorithm>
#include <cmath>

#include "mechanism/element_base/line_force.h"
#include "numerics/curves/linear_table.h"

namespace clevis::mechanism {

namespace {

constexpr double kPhases = 1.5;  // power of three phases by peak values

}  // namespace

double motor_effort(const MotorLaw& law, double t, double rate,
                    const double* internal, double* rates, MotorState& state) {
  const double i_d = internal[0], i_q = internal[1];
  const double L = law.inductance;
  state.speed = law.ratio * rate;
  const double electrical = law.pole_pairs * state.speed;
  state.current_d = i_d;
  state.current_q = i_q;
  state.voltage_q = numerics::linear_at(law.times, law.volts, t);
  state.voltage_d =
      law.d_axis == DirectAxis::kDecoupled ? -electrical * L * i_q : 0.0;
  state.torque = kPhases * law.pole_pairs * law.flux * i_q;
  state.power = kPhases * (state.voltage_d * i_d + state.voltage_q * i_q);
  state.loss = kPhases * law.resistance * (i_d * i_d + i_q * i_q);
  state.stored = 0.5 * kPhases * L * (i_d * i_d + i_q * i_q);
  state.supplied = internal[2];
  state.lost = internal[3];
  state.given = internal[4];
  rates[0] =
      (state.voltage_d - law.resistance * i_d + electrical * L * i_q) / L;
  rates[1] = (state.voltage_q - law.resistance * i_q -
              electrical * (L * i_d + law.flux)) /
             L;
  rates[2] = state.power;
  rates[3] = state.loss;
  rates[4] = state.torque * state.speed;
  return law.ratio * state.torque;
}

LineTangent motor_tangent(const MotorLaw& law) {
  constexpr double kShort = 1e-4;  // [s]: links do not vibrate so fast
  const double volts = law.ratio * law.pole_pairs * law.flux;  // per rate
  const double square = kPhases * volts * volts;
  if (square == 0.0) return {};
  const double stiffness = square / law.inductance;
  if (law.resistance == 0.0) return {.stiffness = stiffness};
  const double damping = square / law.resistance;
  if (damping < kShort * stiffness) return {.damping = damping};
  return {.stiffness = stiffness, .damping = damping, .relaxes = true};
}

void motor_scales(const MotorLaw& law, const double* internal, double* scales) {
  // the current whose own field is that of the magnets, and its energy
  const double current = law.flux / law.inductance;
  const double energy = 0.75 * law.inductance * current * current;
  for (int i = 0; i < MotorLaw::kStates; ++i) {
    scales[i] = std::max(i < 2 ? current : energy, std::abs(internal[i]));
  }
}

namespace {

class Motor final : public LineForce {
 public:
  Motor(const LineDefinition& definition, const MotorLaw& law,
        const ReferenceFrame& frame)
      : LineForce(definition, frame), law_(law) {}

  int internal_states() const override { return MotorLaw::kStates; }
  void scales(const double* own, double* scales) const override {
    motor_scales(law_, own, scales);
  }
  double inertia() const override { return law_.inertia_at_joint(); }

 protected:
  LineTangent tangent(const ElementState& /*state*/) const override {
    return motor_tangent(law_);
  }
  double law_effort(const ActingState& state,
                    ElementResponse& now) const override {
    return motor_effort(law_, state.t, now.rate, state.internal + internal,
                        now.internal_rates.data(), now.motor.emplace());
  }

 private:
  const MotorLaw& law_;
};

}  // namespace

ElementProperties properties(const MotorLaw& law) {
  return {.type = "motor",
          .actuation = Actuation::kMachine,
          .breaks = law.times,
          .is_motor = true};
}

std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const MotorLaw& law,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Motor>(definition, law, frame);
}

}  // namespace clevis::mechanism
