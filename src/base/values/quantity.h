#pragma once

#include <string>
#include <string_view>

namespace clevis {

/// Dimensions that a scene value can have. SI inside, without exception.
enum class Dimension {
  kLength,                  // m
  kAngle,                   // rad
  kTime,                    // s
  kMass,                    // kg
  kMassMoment,              // kg m^2
  kForce,                   // N
  kTorque,                  // N m
  kStress,                  // Pa
  kDensity,                 // kg/m^3
  kVelocity,                // m/s
  kAcceleration,            // m/s^2
  kFrequency,               // 1/s (also Hz); not rad/s
  kAngularVelocity,         // rad/s (also rpm); not Hz
  kAngularAcceleration,     // rad/s^2
  kRatio,                   // 1 (also %)
  kCompliance,              // m/N
  kAngularCompliance,       // rad/(N m)
  kStiffness,               // N/m
  kAngularStiffness,        // N m/rad
  kDamping,                 // N s/m
  kAngularDamping,          // N m s/rad
  kInverseVelocity,         // s/m
  kInverseAngularVelocity,  // s/rad
  kVolumePerForce,          // m^3/N
  kArea,                    // m^2
  kVolume,                  // m^3
  kTemperature,             // K; no offset units
  kSpecificHeat,            // J/(kg K)
  kThermalConductance,      // W/K
  kVolumeFlow,              // m^3/s
  kSonicConductance,        // m^3/(s Pa)
  kVoltage,                 // V
  kResistance,              // ohm
  kInductance,              // H
  kMagneticFlux,            // Wb
  kBedding,                 // N/m^3
};

/// The SI value of a text such as "140 mm", "1500 rpm" or "1 %".
///
/// Parsed by udunits2, so any unit it knows is accepted; its database is read
/// at the first call (4 ms). The radian counts as a dimension of its own: 25 Hz
/// is no angular velocity, because it could mean 25 rad/s or 2π·25 rad/s.
/// @throws Error S004 (place = `place`) if the unit is missing, unknown or of
///   another dimension, S006 if the number is not finite. The message lists
///   units that fit.
double parse_quantity(std::string_view text, Dimension dimension,
                      const std::string& place);

/// "mm, m, in" and the like: units that fit the dimension, for messages.
std::string_view accepted_units(Dimension dimension);

}  // namespace clevis
