#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Prints the faces of a CAD file, or of the parts of a scene that are solids
/// with the groups that their joints and selectors find.
/// @throws Error M…; U001 if the scene has no such part, S003 if it is no
///   solid; M017 behind the table if a joint or selector finds no faces.
ExitCode faces_command(const FacesOptions& options);

/// Declares the options of `clevis faces`. @return what runs it.
Run declare_faces(CLI::App& command);

}  // namespace clevis::app
