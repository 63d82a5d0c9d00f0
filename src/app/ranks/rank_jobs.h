#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/processes/worker_pool.h"
#include "app/scenes/load_scene.h"
#include "assessment/job/part_job.h"
#include "elasticity/engine_library/rank_team.h"

namespace clevis::app {

/// Whether a part is hexahedral with so many cells that sharing it pays.
bool pays_to_share(const mesh::PartMesh<3>& mesh);

/// Which parts all ranks solve together: those that deal.II is asked for, else
/// those that pays_to_share().
void choose_shared(std::vector<assessment::PartJob>& jobs);

/// Frees what the first rank alone needs: meshes and loads of shared parts.
void leave_to_first_rank(LoadedScene& loaded,
                         std::vector<assessment::PartJob>& jobs);

/// Checks parts on the ranks of an MPI run: small ones are dealt out, one to
/// a rank at a time; shared ones are checked by the first, and solved by all.
/// @param check  of the part with this index, on each rank that has it.
/// @param finished  hears on rank 0 how many parts are done.
/// @return on rank 0 of all parts, elsewhere nothing.
std::vector<WorkerOutcome> run_on_ranks(
    const elasticity::RankTeam& team,
    const std::vector<assessment::PartJob>& jobs,
    const std::function<std::string(std::size_t)>& check,
    const std::function<void(std::size_t)>& finished);

}  // namespace clevis::app
