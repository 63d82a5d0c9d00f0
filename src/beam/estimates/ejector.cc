#include "beam/estimates/ejector.h"

#include <cmath>

namespace clevis::beam {
namespace {

using machine::EjectorDefinition;

double squared(double x) {
  return x * x;
}

double allowed_stress(const EjectorDefinition& ejector) {
  return ejector.workpiece.yield_strength / ejector.safety_factor;
}

/// Corrected stress with one value changed; 0 where the pusher does not
/// arrive.
double stress_with(EjectorDefinition ejector,
                   double EjectorDefinition::*quantity, double value) {
  ejector.*quantity = value;
  const auto impact = ejector_impact(ejector, {});
  return impact ? impact->stress : 0.0;
}

/// Where the stress first exceeds the limit as the quantity rises from `low`
/// to `high` (by equal ratios); none if it does not, 0 if it does at once.
std::optional<double> first_above(const EjectorDefinition& ejector,
                                  double EjectorDefinition::*quantity,
                                  double low, double high) {
  constexpr int kPieces = 400, kBisections = 60;
  const double limit = allowed_stress(ejector);
  const double ratio = std::pow(high / low, 1.0 / kPieces);
  if (stress_with(ejector, quantity, low) > limit) return 0.0;
  double inside = low;
  for (int i = 1; i <= kPieces; ++i) {
    double outside = low * std::pow(ratio, i);
    if (stress_with(ejector, quantity, outside) <= limit) {
      inside = outside;
      continue;
    }
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (inside + outside);
      (stress_with(ejector, quantity, middle) <= limit ? inside : outside) =
          middle;
    }
    return inside;
  }
  return std::nullopt;
}

}  // namespace

EjectorDrive ejector_drive(const EjectorDefinition& e, Formula formula) {
  const double s = e.travel;
  const double at_spring = s * e.arm_spring / e.arm_magnet;
  EjectorDrive drive;
  drive.pusher_mass = e.inertia / squared(e.arm_pusher);
  drive.pusher_force =
      (e.magnet_force * (1.0 - s / e.magnet_range) * e.arm_magnet -
       e.spring_stiffness * (e.spring_preset + at_spring) * e.arm_spring) /
      e.arm_pusher;
  if (formula == Formula::kPublished) {
    drive.energy =
        e.magnet_force * s * (1.0 - s / e.magnet_range) -
        0.5 * e.spring_stiffness * squared(at_spring - e.spring_preset);
  } else {
    drive.energy =
        e.magnet_force * s * (1.0 - 0.5 * s / e.magnet_range) -
        0.5 * e.spring_stiffness *
            (squared(e.spring_preset + at_spring) - squared(e.spring_preset));
  }
  if (drive.energy > 0.0) {
    drive.pusher_speed = std::sqrt(2.0 * drive.energy / drive.pusher_mass);
  }
  return drive;
}

StruckBar ejector_workpiece(const EjectorDefinition& ejector,
                            Formula deflection) {
  return cantilever(ejector.workpiece, round_section(ejector.diameter),
                    ejector.length, deflection);
}

std::optional<BarImpact> ejector_impact(const EjectorDefinition& ejector,
                                        const EjectorFormulas& formulas,
                                        StruckMass struck_mass) {
  const EjectorDrive drive = ejector_drive(ejector, formulas.drive);
  if (!drive.pusher_speed) return std::nullopt;
  const double times = formulas.speed == Formula::kPublished ? 2.0 : 1.0;
  return impact(ejector_workpiece(ejector, formulas.deflection),
                {.mass = drive.pusher_mass,
                 .speed = times * *drive.pusher_speed,
                 .force = drive.pusher_force},
                struck_mass);
}

std::optional<double> strength_condition(const EjectorDefinition& e,
                                         Formula formula) {
  const EjectorDrive drive = ejector_drive(e, Formula::kPublished);
  if (!drive.pusher_speed || !(drive.pusher_force > 0.0)) return std::nullopt;
  const BarSection section = round_section(e.diameter);
  // 4 E I m CB² [..]/(J_C F² h³), [..] twice the energy
  double under_root =
      4.0 * e.workpiece.youngs_modulus * section.second_moment *
      drive.pusher_mass * squared(e.arm_pusher) * 2.0 * drive.energy /
      (e.inertia * squared(drive.pusher_force) * std::pow(e.length, 3));
  if (formula == Formula::kPublished) {
    under_root /= e.inertia;
  } else {
    under_root += 1.0;
  }
  return drive.pusher_force * e.length / section.section_modulus *
         (1.0 + std::sqrt(under_root));
}

std::vector<EjectorVariant> ejector_variants(const EjectorDefinition& ejector) {
  using enum Formula;
  std::vector<EjectorVariant> variants;
  const auto add = [&](const char* name, const EjectorFormulas& formulas,
                       StruckMass mass = StruckMass::kLeftOut) {
    const double times = formulas.speed == kPublished ? 2.0 : 1.0;
    const EjectorDrive drive = ejector_drive(ejector, formulas.drive);
    variants.push_back({name, times * drive.pusher_speed.value_or(0.0),
                        ejector_impact(ejector, formulas, mass)});
  };
  add("published: V = 2 V_B, h^3/(E I)", {kPublished, kPublished, kPublished});
  add("V = 2 V_B, h^3/(3 E I)", {kCorrected, kPublished, kPublished});
  add("V = V_B, h^3/(E I)", {kPublished, kCorrected, kPublished});
  add("corrected: V = V_B, h^3/(3 E I), work of the forces", {});
  add("corrected, 33/140 of the rod moving along", {}, StruckMass::kMovesAlong);
  return variants;
}

EjectorLimits ejector_limits(const EjectorDefinition& ejector) {
  constexpr double kWide = 1e3;
  const EjectorDrive drive = ejector_drive(ejector);
  EjectorLimits limits;
  limits.stress = allowed_stress(ejector);
  limits.speed = largest_speed(
      ejector_workpiece(ejector),
      {.mass = drive.pusher_mass, .speed = 0.0, .force = drive.pusher_force},
      limits.stress);
  limits.magnet_force =
      first_above(ejector, &EjectorDefinition::magnet_force,
                  ejector.magnet_force / kWide, ejector.magnet_force * kWide);
  limits.travel =
      first_above(ejector, &EjectorDefinition::travel,
                  ejector.magnet_range / kWide, ejector.magnet_range);
  limits.range = first_above(ejector, &EjectorDefinition::magnet_range,
                             ejector.travel, ejector.travel * kWide);
  return limits;
}

}  // namespace clevis::beam
