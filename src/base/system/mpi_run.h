#pragma once

namespace clevis {

/// This process among those that mpirun or srun started together, by the
/// environment they set; a lone process is rank 0 of 1.
int mpi_rank();
int mpi_ranks();

}  // namespace clevis
