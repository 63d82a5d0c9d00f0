#pragma once

#include "app/request/options.h"
#include "base/messages/exit_code.h"
#include "scene/scene.h"

namespace clevis::app {

// The commands that solve live in a library of their own that is loaded on
// demand: the others start without it.
inline constexpr const char* kCheckPlugin = "clevis_check.so";
inline constexpr const char* kCheckEntryName = "clevis_check";
inline constexpr const char* kStudyEntryName = "clevis_study";
inline constexpr const char* kExportEntryName = "clevis_export";
inline constexpr const char* kModesEntryName = "clevis_modes";
inline constexpr const char* kLinkEntryName = "clevis_link_compliances";
using PluginEntry = ExitCode(const Options& options, scene::Scene scene);
using LinkEntry = void(scene::Scene& scene);

}  // namespace clevis::app
