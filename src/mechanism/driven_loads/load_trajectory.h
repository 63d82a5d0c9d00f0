#pragma once

#include <vector>

#include "mechanism/driven_loads/load_scales.h"

namespace clevis::mechanism {

/// Looks at the loads of a driven motion between events until they are smooth
/// from look to look.
class LoadTrajectory {
 public:
  /// @param scales  outlive this.
  explicit LoadTrajectory(LoadScales& scales)
      : scales_(scales), trajectory_(scales.trajectory()) {}

  /// Looks until the cubic through the neighbours of each look meets it.
  /// @param most  looks. @return whether that was enough.
  bool refine(std::size_t most);
  /// The latest time up to which refine() came [s].
  double ended_at() const { return ended_at_; }

 private:
  using At = DrivenTrajectory::At;
  using Piece = std::vector<At>;  ///< looks between which loads are smooth
  std::vector<Piece> pieces();
  bool refine_piece(Piece piece, std::size_t most);
  std::vector<std::size_t> unresolved(const Piece& piece) const;

  LoadScales& scales_;
  DrivenTrajectory& trajectory_;
  double ended_at_ = 0.0;
};

}  // namespace clevis::mechanism
