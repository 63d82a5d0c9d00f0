#include "app/ranks/rank_jobs.h"

#include <algorithm>

#include <malloc.h>

#include "app/request/error_output.h"
#include "base/system/mpi_run.h"
#include "base/system/system_failure.h"
#include "elasticity/dealii/dealii_service.h"

namespace clevis::app {

using assessment::PartJob;
using elasticity::Engine;

namespace {

/// Takes part in the first rank's solves of a part until it has its result.
void serve(const elasticity::RankTeam& team, const std::string& part) {
  try {
    elasticity::serve_dealii();
  } catch (const std::exception& failure) {
    const Error error = system_failure(failure, "part " + part);
    print_error(error, ErrorFormat::kText);
    team.abort(static_cast<int>(error.exit_code()));
  }
}

}  // namespace

bool pays_to_share(const mesh::PartMesh<3>& mesh) {
  constexpr std::size_t kManyCells = 5000;
  return mesh.shape == mesh::CellShape::kTensor &&
         mesh.cells.size() >= kManyCells;
}

void choose_shared(std::vector<PartJob>& jobs) {
  for (PartJob& job : jobs) {
    job.is_shared = job.engine == Engine::kDealii ||
                    (job.engine == Engine::kAuto && pays_to_share(job.mesh));
  }
}

void leave_to_first_rank(LoadedScene& loaded, std::vector<PartJob>& jobs) {
  for (PartJob& job : jobs) {
    if (!job.is_shared) continue;
    const std::string& name = job.part.name;
    const auto part =
        std::ranges::find(loaded.parts, name, [](const LoadedPart& p) {
          return p.definition.name;
        });
    part->mesh = job.mesh = {};
    part->unrefined = job.unrefined = {};
    job.load_sets.clear();
  }
  malloc_trim(0);  // cells are many small pieces, which the heap would keep
}

std::vector<WorkerOutcome> run_on_ranks(
    const elasticity::RankTeam& team, const std::vector<PartJob>& jobs,
    const std::function<std::string(std::size_t)>& check,
    const std::function<void(std::size_t)>& finished) {
  const auto ranks = static_cast<std::size_t>(mpi_ranks());
  const auto rank = static_cast<std::size_t>(mpi_rank());
  std::vector<WorkerOutcome> outcomes(rank == 0 ? jobs.size() : 0);
  std::vector<std::size_t> dealt;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    if (!jobs[j].is_shared) dealt.push_back(j);
  }
  std::size_t done = 0;
  for (std::size_t first = 0; first < dealt.size(); first += ranks) {
    const std::size_t mine = first + rank;
    const auto texts =
        team.gather(mine < dealt.size() ? check(dealt[mine]) : "");
    for (std::size_t r = 0; r < texts.size(); ++r) {
      if (first + r >= dealt.size()) break;
      outcomes[dealt[first + r]] = {WorkerOutcome::Kind::kDone, texts[r]};
      finished(++done);
    }
  }
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    if (!jobs[j].is_shared) continue;
    if (rank == 0) {
      outcomes[j] = {WorkerOutcome::Kind::kDone, check(j)};
      elasticity::dismiss_dealii();
      finished(++done);
    } else {
      serve(team, jobs[j].part.name);
    }
  }
  return outcomes;
}

}  // namespace clevis::app
