#pragma once

#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Writes the glTF of a result and prints its name; `scene` is the folder of
/// the result, or the scene that it is of.
/// @throws Error I003, I008 if the folder holds no whole result.
ExitCode glb_command(const Options& options);

}  // namespace clevis::app
