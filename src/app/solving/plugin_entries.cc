#include "app/solving/plugin_entries.h"

#include <utility>

#include "app/parts/link_compliance.h"
#include "app/solving/check_run.h"
#include "app/solving/export_run.h"
#include "app/solving/modes_run.h"
#include "app/solving/study_run.h"
#include "base/system/interrupts.h"
#include "base/system/system_failure.h"
#include "elasticity/algebra/blas_space.h"

namespace {

using clevis::app::Options;

void take_blas_memory() {
  if (!clevis::elasticity::take_blas_space(1)) {
    throw clevis::out_of_resources("clevis", "no memory for linear algebra");
  }
}

clevis::ExitCode run(clevis::ExitCode (*command)(const Options&,
                                                 clevis::scene::Scene),
                     const Options& options, clevis::scene::Scene scene) {
  clevis::end_on_interrupts();
  take_blas_memory();
  return command(options, std::move(scene));
}

}  // namespace

#define CLEVIS_ENTRY extern "C" __attribute__((visibility("default")))

CLEVIS_ENTRY clevis::ExitCode clevis_check(const clevis::app::Options& options,
                                           clevis::scene::Scene scene) {
  return run(clevis::app::run_check, options, std::move(scene));
}

CLEVIS_ENTRY clevis::ExitCode clevis_study(const clevis::app::Options& options,
                                           clevis::scene::Scene scene) {
  return run(clevis::app::run_study, options, std::move(scene));
}

CLEVIS_ENTRY clevis::ExitCode clevis_export(const clevis::app::Options& options,
                                            clevis::scene::Scene scene) {
  return run(clevis::app::run_export, options, std::move(scene));
}

CLEVIS_ENTRY clevis::ExitCode clevis_modes(const clevis::app::Options& options,
                                           clevis::scene::Scene scene) {
  return run(clevis::app::run_modes, options, std::move(scene));
}

CLEVIS_ENTRY void clevis_link_compliances(clevis::scene::Scene& scene) {
  take_blas_memory();
  clevis::app::LoadedScene loaded = clevis::app::load_scene(scene);
  clevis::app::add_link_compliances(loaded);
  scene.mechanism = std::move(loaded.scene.mechanism);
}
