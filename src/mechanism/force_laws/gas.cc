#include "mechanism/force_laws/gas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clevis::mechanism {
namespace {

/// Flow over choked flow at r = p₂/p₁ ≤ 1.
double flow_part(const Orifice& o, double r) {
  const auto ellipse = [&o](double ratio) {
    const double s = (ratio - o.critical_ratio) / (1.0 - o.critical_ratio);
    return std::sqrt(std::max(0.0, 1.0 - s * s));
  };
  if (r <= o.critical_ratio) return 1.0;
  if (r <= o.laminar_ratio) return ellipse(r);
  // a z + c z³, with the ellipse's value and slope at its end
  const double s =
      (o.laminar_ratio - o.critical_ratio) / (1.0 - o.critical_ratio);
  const double end = 1.0 - o.laminar_ratio;
  const double value = ellipse(o.laminar_ratio);
  const double slope = s / (value * (1.0 - o.critical_ratio));
  const double cubic = (slope - value / end) / (2.0 * end * end);
  const double linear = value / end - cubic * end * end;
  const double z = 1.0 - r;
  return z * (linear + cubic * z * z);
}

}  // namespace

GasFlow orifice_flow(const Orifice& orifice, const Gas& gas, const GasState& a,
                     const GasState& b) {
  if (a.pressure < b.pressure) {
    const GasFlow back = orifice_flow(orifice, gas, b, a);
    return {-back.mass, -back.enthalpy};
  }
  const double choked = a.pressure * orifice.conductance * kReferenceDensity *
                        std::sqrt(kReferenceTemperature / a.temperature);
  const double mass = choked * flow_part(orifice, b.pressure / a.pressure);
  return {mass, mass * gas.specific_heat * a.temperature};
}

double conductance_of_kv(double kv, double critical_ratio) {
  // water of 1000 kg/m³ at a drop of 1e5 Pa: m' = K sqrt(density drop)
  const double per_kv = std::sqrt(1000.0 / 1e5) / 3600.0;
  return per_kv * kv * std::sqrt(0.5 * (1.0 - critical_ratio)) /
         std::sqrt(kReferenceDensity * kReferencePressure);
}

double conductance_of_cv(double cv, double critical_ratio) {
  return conductance_of_kv(0.865 * cv, critical_ratio);
}

double conductance_of_area(double area, double discharge, const Gas& gas) {
  const double k = gas.isentropic_exponent();
  const double choked =
      std::sqrt(k / (gas.gas_constant * kReferenceTemperature)) *
      std::pow(2.0 / (k + 1.0), 0.5 * (k + 1.0) / (k - 1.0));
  return discharge * area * choked / kReferenceDensity;
}

double valve_opening(double signal, double smoothing) {
  const double s = std::clamp(signal, 0.0, 1.0);
  if (smoothing <= 0.0) return s;
  const double slope = 1.0 / (1.0 - smoothing);
  const auto corner = [&](double x) {
    return 0.5 * slope * x * x / smoothing;
  };
  if (s < smoothing) return corner(s);
  if (s > 1.0 - smoothing) return 1.0 - corner(1.0 - s);
  return slope * (s - 0.5 * smoothing);
}

GasState chamber_state(const Gas& gas, const ChamberContent& content,
                       double volume) {
  if (!(volume > 0.0 && content.mass > 0.0 && content.energy > 0.0)) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none};
  }
  return {gas.gas_constant / gas.c_v() * content.energy / volume,
          content.energy / (content.mass * gas.c_v())};
}

ChamberContent chamber_content(const Gas& gas, const GasState& state,
                               double volume) {
  const double pV = state.pressure * volume;
  return {pV / (gas.gas_constant * state.temperature),
          gas.c_v() / gas.gas_constant * pV};
}

ChamberContent chamber_rates(const GasState& state, const GasFlow& inflow,
                             double volume_rate, double heat) {
  return {inflow.mass, inflow.enthalpy - state.pressure * volume_rate + heat};
}

}  // namespace clevis::mechanism
