#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Writes mechanism.glb of a result and prints where it stands; the option
/// `scene` is the result's folder, or the scene that it is of.
/// @throws Error as read_result_folder, I002.
ExitCode glb_command(const Options& options);

}  // namespace clevis::app
