#pragma once

#include "mechanism/force_element.h"

namespace clevis::mechanism {

/// Effort of a penetration, without the bound at 0.
/// @param depth  > 0 [m]; @param rate  of it [m/s].
double contact_effort(const ContactLaw& law, double depth, double rate);

/// Whether the law lets the bodies pull at one another until depth is 0.
inline bool may_pull(const ContactLaw& law) {
  return law.model == ContactModel::kPublished;
}

/// Size of the kinetic friction at |v|, without the viscous part.
double kinetic_effort(const FrictionLaw& law, double speed);

/// Coefficient of sliding friction: rises to the static one at the critical
/// speed, falls to the kinetic one beyond it; smooth.
double friction_coefficient(const ContactElement& contact, double speed);

double servo_effort(const ServoLaw& law, double t, double q, double rate);

}  // namespace clevis::mechanism
