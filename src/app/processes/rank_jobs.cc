#include "app/processes/rank_jobs.h"

#include "base/mpi_run.h"

namespace clevis::app {

using assessment::PartJob;
using elasticity::Engine;

void choose_shared(std::vector<PartJob>& jobs) {
  constexpr std::size_t kManyCells = 5000;
  for (PartJob& job : jobs) {
    job.is_shared = job.engine == Engine::kDealii ||
                    (job.engine == Engine::kAuto &&
                     job.mesh.shape == mesh::CellShape::kTensor &&
                     job.mesh.cells.size() >= kManyCells);
  }
}

std::vector<WorkerOutcome> run_on_ranks(
    const elasticity::RankTeam& team, const std::vector<PartJob>& jobs,
    const std::function<std::string(std::size_t)>& check) {
  const auto ranks = static_cast<std::size_t>(mpi_ranks());
  const auto rank = static_cast<std::size_t>(mpi_rank());
  std::vector<WorkerOutcome> outcomes(rank == 0 ? jobs.size() : 0);
  std::vector<std::size_t> dealt;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    if (!jobs[j].is_shared) dealt.push_back(j);
  }
  for (std::size_t first = 0; first < dealt.size(); first += ranks) {
    const std::size_t mine = first + rank;
    const auto texts =
        team.gather(mine < dealt.size() ? check(dealt[mine]) : "");
    for (std::size_t r = 0; r < texts.size(); ++r) {
      if (first + r >= dealt.size()) break;
      outcomes[dealt[first + r]] = {WorkerOutcome::Kind::kDone, texts[r]};
    }
  }
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    if (!jobs[j].is_shared) continue;
    const auto texts = team.gather(check(j));
    if (rank == 0) outcomes[j] = {WorkerOutcome::Kind::kDone, texts.front()};
  }
  return outcomes;
}

}  // namespace clevis::app
