#pragma once

#include <string>

#include "machine/bearings/bearing.h"

namespace clevis::report {

/// A bearing's result with the name of its joint.
struct BearingReport {
  machine::BearingResult result;
  std::string joint;
};

}  // namespace clevis::report
