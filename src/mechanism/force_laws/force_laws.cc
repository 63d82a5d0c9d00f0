#include "mechanism/force_laws/force_laws.h"

#include <algorithm>
#include <cmath>

#include "mechanism/drives/drive_law.h"

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

double unlimited_servo_effort(const ServoLaw& law, double t, double q,
                              double rate) {
  const DriveTarget target = drive_target(law.reference, t);
  return -law.stiffness * (q - target.position) -
         law.damping * (rate - target.rate);
}

double servo_effort(const ServoLaw& law, double t, double q, double rate) {
  const double wanted = unlimited_servo_effort(law, t, q, rate);
  return law.limit ? std::clamp(wanted, -*law.limit, *law.limit) : wanted;
}

int piece_at(const TableLaw& law, double position) {
  return static_cast<int>(std::ranges::upper_bound(law.positions, position) -
                          law.positions.begin());
}

double piece_effort(const TableLaw& law, int piece, double position) {
  const auto at = static_cast<std::size_t>(piece);
  if (at == 0) return law.efforts.front();
  if (at == law.positions.size()) return law.efforts.back();
  const double s = (position - law.positions[at - 1]) /
                   (law.positions[at] - law.positions[at - 1]);
  return law.efforts[at - 1] + s * (law.efforts[at] - law.efforts[at - 1]);
}

}  // namespace clevis::mechanism
