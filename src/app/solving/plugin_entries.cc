#include "app/solving/plugin_entries.h"

#include <cstddef>
#include <utility>

#include <Eigen/Core>
#include <sys/mman.h>

#include "app/parts/link_compliance.h"
#include "app/solving/check_run.h"
#include "app/solving/export_run.h"
#include "app/solving/modes_run.h"
#include "app/solving/study_run.h"
#include "base/system/interrupts.h"
#include "base/system/system_failure.h"
#include "elasticity/algebra/dense_product.h"

namespace {

using clevis::app::Options;

/// OpenBLAS tries for ever where it gets no memory for its working space: tries
/// first whether there is some, then lets it take that. Worker processes share
/// it.
void take_blas_memory() {
  constexpr std::size_t kWanted = std::size_t{192} << 20;  // [byte]
  void* space = mmap(nullptr, kWanted, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (space == MAP_FAILED) {
    throw clevis::out_of_resources("clevis", "no memory for linear algebra");
  }
  munmap(space, kWanted);
  constexpr int kSize = 128;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Identity(kSize, kSize);
  clevis::elasticity::transposed_product(a, a);
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
