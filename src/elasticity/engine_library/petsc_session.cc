#include "elasticity/engine_library/petsc_session.h"

#include <cstdlib>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/system/mpi_run.h"

namespace clevis::elasticity {

void start_petsc() {
  static const bool once = [] {
    if (mpi_ranks() == 1) {
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      setenv("OMPI_MCA_btl", "self", 0);
      setenv("OMPI_MCA_pml", "ob1", 0);
    }
    PetscInitializeNoArguments();
    PetscPopSignalHandler();
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    return true;
  }();
  static_cast<void>(once);
}

void require_petsc(PetscErrorCode code, const std::string& name,
                   const char* stage) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw Error("F002", name,
              fmt::format("PETSc failed in {}: {}", stage,
                          text != nullptr ? text : "unknown error"),
              "Check the mesh quality and the material.");
}

}  // namespace clevis::elasticity
