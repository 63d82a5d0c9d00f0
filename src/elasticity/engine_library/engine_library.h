#pragma once

namespace clevis::elasticity {

/// A function of the library that holds what needs deal.II, PETSc and MPI. With
/// some 300 other libraries it takes 0.3 s to load: when first asked for.
/// @throws Error I001 if it is not there, X001 if it has no such function.
void* find_engine_function(const char* name);

template <class Function>
Function* engine_function(const char* name) {
  return reinterpret_cast<Function*>(find_engine_function(name));
}

}  // namespace clevis::elasticity

/// Marks what is found so.
#define CLEVIS_ENGINE_ENTRY extern "C" __attribute__((visibility("default")))
