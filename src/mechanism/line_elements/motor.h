#pragma once

#include <memory>
#include <vector>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/element_response.h"
#include "mechanism/element_base/element_state.h"
#include "mechanism/element_base/force_line.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// Who sets the voltage of the d axis.
enum class DirectAxis {
  kDecoupled,  ///< v_d = −p ω L i_q, so that i_d stays zero
  kZero        ///< v_d = 0
};

/// Synchronous motor with permanent magnets and without saliency (L_d = L_q),
/// in the frame of its rotor, behind a gear of `ratio`: ω = ratio × the
/// joint's rate. Peak values of the phases:
///
///     v_q = R i_q + L i_q' + p ω (L i_d + ψ)
///     v_d = R i_d + L i_d' − p ω L i_q
///     T = 3/2 p ψ i_q,   effort = ratio (T − J ω')
struct MotorLaw {
  /// i_d, i_q, and since the start: energy supplied, lost in the windings,
  /// given to the rotor.
  static constexpr int kStates = 5;

  double ratio = 1.0;      ///< turns of the rotor per turn of the joint
  int pole_pairs = 1;      ///< p
  double resistance{};     ///< R of a phase [Ω]
  double inductance{};     ///< L [H]
  double flux{};           ///< ψ of the magnets [Wb]
  double rotor_inertia{};  ///< J [kg m²]
  std::vector<double> times, volts;  ///< v_q [V], linear between
  DirectAxis d_axis = DirectAxis::kDecoupled;

  /// J seen at the joint [kg m²].
  double inertia_at_joint() const { return ratio * ratio * rotor_inertia; }
};

/// Torque on the joint without that of the rotor's inertia [N m].
/// @param rate  of the joint [rad/s]. @param internal  its states.
double motor_effort(const MotorLaw& law, double t, double rate,
                    const double* internal, double* rates, MotorState& state);

/// What small, fast turns of the rotor meet: current that they induce, which
/// builds up against the inductance and decays by the resistance. Of the flux
/// of the magnets; what currents of the d axis do at speed is left out.
LineTangent motor_tangent(const MotorLaw& law);

/// A size that is large for each internal state.
void motor_scales(const MotorLaw& law, const double* internal, double* scales);

ElementProperties properties(const MotorLaw& law);
/// @param law  outlives the result.
std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const MotorLaw& law,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
