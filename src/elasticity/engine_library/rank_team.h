#pragma once

#include <string>
#include <vector>

namespace clevis::elasticity {

/// The ranks of an MPI run, which start and finish together.
class RankTeam {
 public:
  /// Starts MPI, on all ranks.
  RankTeam();
  /// Ends it. @pre nothing of PETSc or deal.II is left.
  ~RankTeam();
  RankTeam(const RankTeam&) = delete;
  RankTeam& operator=(const RankTeam&) = delete;

  /// The texts of all ranks, in their order, on rank 0; elsewhere nothing.
  std::vector<std::string> gather(const std::string& text) const;

  /// Ends all ranks at once, where one cannot go on and the others wait for it.
  [[noreturn]] void abort(int exit_code) const;
};

}  // namespace clevis::elasticity
