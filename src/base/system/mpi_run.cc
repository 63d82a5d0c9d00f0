#include "base/system/mpi_run.h"

#include <cstdlib>
#include <initializer_list>

namespace clevis {
namespace {

/// The first of some variables that is set; PMI's are those of MPICH and of
/// SLURM's srun.
int number_in(const char* of_openmpi, const char* of_pmi, int otherwise) {
  for (const char* name : {of_openmpi, of_pmi}) {
    if (const char* value = std::getenv(name)) return std::atoi(value);
  }
  return otherwise;
}

}  // namespace

int mpi_rank() {
  return number_in("OMPI_COMM_WORLD_RANK", "PMI_RANK", 0);
}

int mpi_ranks() {
  return number_in("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", 1);
}

}  // namespace clevis
