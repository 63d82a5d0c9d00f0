#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/drives/drive_definition.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// Times [s] at which the laws of a mechanism's drives and forces bend: no step
/// of an integration passes one.
class LawBreaks {
 public:
  LawBreaks(const MechanismDefinition& definition, const ForceModel& forces,
            double duration);

  /// The first one after t, or the duration [s].
  double after(double t) const;
  /// Whether the velocity of a drive jumps at t.
  bool is_jump(double t) const;

 private:
  double duration_;
  std::vector<double> times_;
  std::vector<DriveJump> jumps_;
};

}  // namespace clevis::mechanism
