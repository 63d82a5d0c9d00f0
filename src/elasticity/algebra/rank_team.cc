#include "elasticity/algebra/rank_team.h"

#include <cstdlib>
#include <numeric>

#include <petscsys.h>

#include "base/mpi_run.h"
#include "elasticity/algebra/petsc_session.h"

namespace clevis::elasticity {

RankTeam::RankTeam() {
  start_petsc();
}

RankTeam::~RankTeam() {
  PetscFinalize();
}

std::vector<std::string> RankTeam::gather(const std::string& text) const {
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

void RankTeam::abort(int exit_code) const {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::abort();
}

}  // namespace clevis::elasticity
