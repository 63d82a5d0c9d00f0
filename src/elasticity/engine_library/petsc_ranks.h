#pragma once

#include <string>
#include <vector>

namespace clevis::elasticity {

/// What RankTeam is made of, in the library of deal.II and PETSc.
struct PetscRanks {
  void (*start)();
  void (*finish)();
  std::vector<std::string> (*gather)(const std::string& text);
  void (*abort)(int exit_code);
};

/// The library's function that tells, and its name.
using RanksEntry = PetscRanks();
inline constexpr const char* kRanksEntry = "clevis_petsc_ranks";

}  // namespace clevis::elasticity
