#pragma once

#include "app/request/options.h"
#include "report/check/check_inputs.h"

namespace clevis::app {

/// Inputs of a check with these options, from the files as they are.
/// @throws Error S…, I001 as read_scene().
report::CheckInputs check_inputs(const Options& options);

}  // namespace clevis::app
