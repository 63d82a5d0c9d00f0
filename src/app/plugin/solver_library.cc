#include "app/plugin/solver_library.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <utility>

#include <dlfcn.h>
#include <malloc.h>

#include "app/request/options.h"
#include "app/scenes/mesh_parts.h"
#include "app/solving/plugin_entries.h"
#include "base/messages/errors.h"
#include "base/system/companion.h"
#include "base/system/instruction_set.h"
#include "base/system/system_failure.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

/// Takes effect when the library loads.
void set_up_blas() {
  // Parts run in processes of their own; BLAS threads on top would only get
  // in their way and change the order of sums.
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  setenv("OMP_NUM_THREADS", "1", 1);
  setenv("DEAL_II_NUM_THREADS", "1", 1);  // it aborts at what is no number
  // OpenBLAS 0.3.21 takes processors younger than itself for Haswell, which
  // halves the speed of those with AVX-512.
  if (instruction_set() == InstructionSet::kAvx512) {
    setenv("OPENBLAS_CORETYPE", "SkylakeX", 0);
  }
}

/// Matrices come and go by the megabyte: pages that went back to the system
/// would be cleared and mapped anew each time, a tenth of a check.
void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kLargest = 32 << 20;  // what glibc takes from the heap at most
  constexpr int kKept = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, kLargest);
  mallopt(M_TRIM_THRESHOLD, kKept);
#endif
}

void* plugin_handle(const fs::path& path) {
  set_up_blas();
  keep_freed_memory();
  void* plugin = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (plugin == nullptr) throw load_failure(path.string(), dlerror());
  return plugin;
}

/// Loads the library and finds a function of it.
void* plugin_entry(const char* entry_name) {
  const fs::path path = companion(kCheckPlugin);
  void* entry = dlsym(plugin_handle(path), entry_name);
  if (entry == nullptr) {
    throw Error("X001", path.string(), dlerror(),
                "The executable and its library are of different versions.");
  }
  return entry;
}

}  // namespace

fs::path load_plugin() {
  const fs::path path = companion(kCheckPlugin);
  plugin_handle(path);
  return path;
}

ExitCode run_in_plugin(const char* entry_name, const Options& options) {
  scene::Scene scene = scene_to_solve(options, std::cerr);
  return reinterpret_cast<PluginEntry*>(plugin_entry(entry_name))(
      options, std::move(scene));
}

void add_link_compliances_by_plugin(scene::Scene& scene) {
  reinterpret_cast<LinkEntry*>(plugin_entry(kLinkEntryName))(scene);
}

}  // namespace clevis::app
