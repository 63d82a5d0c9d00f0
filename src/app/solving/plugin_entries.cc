#include "app/solving/plugin_entries.h"

#include "app/parts/link_compliance.h"
#include "app/solving/check_run.h"
#include "app/solving/export_run.h"
#include "app/solving/modes_run.h"
#include "app/solving/study_run.h"

#define CLEVIS_ENTRY extern "C" __attribute__((visibility("default")))

CLEVIS_ENTRY clevis::ExitCode clevis_check(
    const clevis::app::Options& options) {
  return clevis::app::run_check(options);
}

CLEVIS_ENTRY clevis::ExitCode clevis_study(
    const clevis::app::Options& options) {
  return clevis::app::run_study(options);
}

CLEVIS_ENTRY clevis::ExitCode clevis_export(
    const clevis::app::Options& options) {
  return clevis::app::run_export(options);
}

CLEVIS_ENTRY clevis::ExitCode clevis_modes(
    const clevis::app::Options& options) {
  return clevis::app::run_modes(options);
}

CLEVIS_ENTRY void clevis_link_compliances(clevis::scene::Scene& scene,
                                          const clevis::app::Options& options) {
  clevis::app::LoadedScene loaded =
      clevis::app::load_scene(options.scene, options.settings);
  clevis::app::add_link_compliances(loaded);
  scene.mechanism = std::move(loaded.scene.mechanism);
}
