#include "elasticity/engine_library/rank_team.h"

#include <cstdlib>

#include "elasticity/engine_library/engine_library.h"
#include "elasticity/engine_library/petsc_ranks.h"

namespace clevis::elasticity {
namespace {

PetscRanks ranks() {
  return engine_function<RanksEntry>(kRanksEntry)();
}

}  // namespace

RankTeam::RankTeam() {
  ranks().start();
}

RankTeam::~RankTeam() {
  ranks().finish();
}

std::vector<std::string> RankTeam::gather(const std::string& text) const {
  return ranks().gather(text);
}

void RankTeam::abort(int exit_code) const {
  ranks().abort(exit_code);
  std::abort();
}

}  // namespace clevis::elasticity
