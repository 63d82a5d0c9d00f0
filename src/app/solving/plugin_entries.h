#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"
#include "scene/scene.h"

namespace clevis::app {

// The commands that solve live in a library of their own that is loaded on
// demand: only they pay for loading deal.II (0.3–0.6 s).
inline constexpr const char* kCheckPlugin = "clevis_check.so";
inline constexpr const char* kCheckEntryName = "clevis_check";
inline constexpr const char* kStudyEntryName = "clevis_study";
inline constexpr const char* kExportEntryName = "clevis_export";
inline constexpr const char* kModesEntryName = "clevis_modes";
inline constexpr const char* kLinkEntryName = "clevis_link_compliances";
using PluginEntry = ExitCode(const Options& options);
using LinkEntry = void(scene::Scene& scene, const Options& options);

}  // namespace clevis::app
