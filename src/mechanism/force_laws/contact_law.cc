#include "mechanism/force_laws/contact_law.h"

#include <algorithm>
#include <cmath>

namespace clevis::mechanism {

double contact_effort(const ContactLaw& law, double depth, double rate) {
  if (law.model == ContactModel::kHuntCrossley) {
    return law.stiffness * std::pow(std::max(depth, 0.0), law.exponent) *
           (1.0 + law.damping * rate);
  }
  const double full = law.stiffness * depth + law.damping * rate;
  if (law.model == ContactModel::kPublished || law.transition <= 0.0) {
    return full;
  }
  const double s = std::clamp(depth / law.transition, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s) * full;
}

double contact_sign(const ContactLaw& law, double depth, double rate) {
  return law.model == ContactModel::kHuntCrossley
             ? 1.0 + law.damping * rate
             : law.stiffness * depth + law.damping * rate;
}

}  // namespace clevis::mechanism
