#include "elasticity/engine_library/engine_library.h"

#include <dlfcn.h>

#include "base/messages/errors.h"
#include "base/system/companion.h"
#include "base/system/instruction_set.h"
#include "base/system/system_failure.h"

namespace clevis::elasticity {
namespace {

/// Found beside the library or program that this is part of, by its run path.
void* library() {
  static void* const handle = [] {
    void* found = nullptr;
    if (instruction_set() >= InstructionSet::kAvx2) {
      found = dlopen(kEngineInLanes, RTLD_NOW | RTLD_LOCAL);
    }
    return found != nullptr ? found
                            : dlopen(kEngineLibrary, RTLD_NOW | RTLD_LOCAL);
  }();
  if (handle == nullptr) throw load_failure(kEngineLibrary, dlerror());
  return handle;
}

}  // namespace

void* find_engine_function(const char* name) {
  void* function = dlsym(library(), name);
  if (function == nullptr) {
    throw Error("X001", kEngineLibrary, dlerror(),
                "The executable and its library are of different versions.");
  }
  return function;
}

}  // namespace clevis::elasticity
