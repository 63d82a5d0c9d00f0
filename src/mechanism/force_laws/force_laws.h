#pragma once

#include "mechanism/force_laws/force_element.h"

namespace clevis::mechanism {

/// Effort of a penetration, without the bound at 0.
/// @param depth  > 0 [m]; @param rate  of it [m/s].
double contact_effort(const ContactLaw& law, double depth, double rate);

/// Whether the law lets the bodies pull at one another until depth is 0.
inline bool may_pull(const ContactLaw& law) {
  return law.model == ContactModel::kPublished;
}

/// What a servo would give without its limit.
double unlimited_servo_effort(const ServoLaw& law, double t, double q,
                              double rate);
double servo_effort(const ServoLaw& law, double t, double q, double rate);

/// Effort of a table over positions on one of its pieces: 0 before the first
/// point, positions.size() behind the last; a piece goes on beyond its ends.
double piece_effort(const TableLaw& law, int piece, double position);
/// The piece that holds a position.
int piece_at(const TableLaw& law, double position);

}  // namespace clevis::mechanism
