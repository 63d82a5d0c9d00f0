#pragma once

namespace clevis::mechanism {

/// An ideal gas of constant specific heats; dry air by default.
struct Gas {
  double gas_constant = 287.0;    ///< R [J/(kg K)]
  double specific_heat = 1005.0;  ///< c_p [J/(kg K)]

  /// At constant volume [J/(kg K)].
  double c_v() const { return specific_heat - gas_constant; }
  /// c_p/c_v [1].
  double isentropic_exponent() const { return specific_heat / c_v(); }
};

/// Pressure and temperature, absolute.
struct GasState {
  double pressure{};     ///< [Pa]
  double temperature{};  ///< [K]
};

/// Reference of sonic conductances ([ISO8778]): 20 °C, 100 kPa.
inline constexpr double kReferenceDensity = 1.185;       // [kg/m³]
inline constexpr double kReferencePressure = 1e5;        // [Pa]
inline constexpr double kReferenceTemperature = 293.15;  // [K]

/// Flow through an orifice by [ISO6358].
struct Orifice {
  double conductance{};         ///< sonic, C [m³/(s Pa)]
  double critical_ratio = 0.3;  ///< b: choked below this p₂/p₁
  double laminar_ratio = 0.999;  ///< above it a cubic in 1 − p₂/p₁, not a root
};

/// Flow from a to b; negative from b to a.
struct GasFlow {
  double mass{};      ///< [kg/s]
  double enthalpy{};  ///< c_p T of where it comes from, times mass [W]
};
GasFlow orifice_flow(const Orifice& orifice, const Gas& gas, const GasState& a,
                     const GasState& b);

/// Sonic conductance [m³/(s Pa)] of the same flow at a small pressure drop.
/// @param kv  [m³/h] of water at 1 bar. @param critical_ratio  of the orifice.
double conductance_of_kv(double kv, double critical_ratio);
/// The same [m³/(s Pa)]. @param cv  [US gal/min at 1 psi]; K_v = 0.865 C_v.
double conductance_of_cv(double cv, double critical_ratio);
/// Sonic conductance of an ideal nozzle [m³/(s Pa)].
/// @param area  [m²]. @param discharge  of it, that is reached [1].
double conductance_of_area(double area, double discharge, const Gas& gas);

/// Part of a valve's conductance [1] at a signal s [1]: 0 below 0, 1 above 1,
/// linear between, with rounded corners `smoothing` wide (< 1/2) inside.
double valve_opening(double signal, double smoothing);

/// Contents of a chamber. Both are sums of what came in: mass and energy are
/// then in balance to round-off, whatever the steps.
struct ChamberContent {
  double mass{};    ///< [kg]
  double energy{};  ///< internal, m c_v T [J]
};

/// @param volume  [m³]. NaN unless volume and content are positive.
GasState chamber_state(const Gas& gas, const ChamberContent& content,
                       double volume);
ChamberContent chamber_content(const Gas& gas, const GasState& state,
                               double volume);

/// Rates of a chamber's contents [kg/s], [W].
/// @param inflow  sum of all. @param volume_rate  [m³/s]. @param heat  into the
///   gas [W].
ChamberContent chamber_rates(const GasState& state, const GasFlow& inflow,
                             double volume_rate, double heat);

}  // namespace clevis::mechanism
