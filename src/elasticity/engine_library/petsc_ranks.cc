#include "elasticity/engine_library/petsc_ranks.h"

#include <cstddef>
#include <numeric>

#include <petscsys.h>

#include "base/system/mpi_run.h"
#include "elasticity/engine_library/engine_library.h"
#include "elasticity/engine_library/petsc_session.h"

namespace clevis::elasticity {
namespace {

std::vector<std::string> gather(const std::string& text) {
  const auto ranks = static_cast<std::size_t>(mpi_ranks());
  const int size = static_cast<int>(text.size());
  std::vector<int> sizes(ranks);
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::vector<int> starts(ranks);
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  const bool is_first = mpi_rank() == 0;
  std::string all(
      is_first ? static_cast<std::size_t>(starts.back() + sizes.back()) : 0,
      ' ');
  MPI_Gatherv(text.data(), size, MPI_CHAR, all.data(), sizes.data(),
              starts.data(), MPI_CHAR, 0, MPI_COMM_WORLD);
  std::vector<std::string> texts;
  for (std::size_t r = 0; is_first && r < ranks; ++r) {
    texts.push_back(all.substr(static_cast<std::size_t>(starts[r]),
                               static_cast<std::size_t>(sizes[r])));
  }
  return texts;
}

}  // namespace

CLEVIS_ENGINE_ENTRY PetscRanks clevis_petsc_ranks() {
  return {start_petsc,
          [] {
            PetscFinalize();
          },
          gather,
          [](int exit_code) {
            MPI_Abort(MPI_COMM_WORLD, exit_code);
          }};
}

}  // namespace clevis::elasticity
