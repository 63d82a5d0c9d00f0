#pragma once

#include <vector>

#include "cad/cylinders.h"
#include "part/solid_source.h"

namespace clevis::cad {

/// The cylinder that a joint's pin fills, or the shaft that it holds: coaxial
/// with the joint and about its point. Bores go before shafts (an eye is round
/// outside too); bores of one diameter on both sides of the point, the ears of
/// a fork, belong together.
/// @return the cylinders whose faces are the joint's.
/// @throws Error M017 if there is none, with all cylinders of the part; or if
///   several diameters fit, with those.
std::vector<Cylinder> joint_cylinders(const Solid& solid,
                                      const part::JointFaces& joint);

}  // namespace clevis::cad
