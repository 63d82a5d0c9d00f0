#pragma once

#include <string>

#include <petscsys.h>

namespace clevis::elasticity {

/// Starts MPI and PETSc, once per process. A lone process starts without
/// OpenMPI's launcher, which would cost a daemon and 0.3 s.
void start_petsc();

/// @param name   entity for the message ("part DCE").
/// @param stage  what was done.
/// @throws Error F002 if PETSc refused.
void require_petsc(PetscErrorCode code, const std::string& name,
                   const char* stage);

}  // namespace clevis::elasticity
