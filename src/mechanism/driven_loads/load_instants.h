#pragma once

#include <vector>

#include "mechanism/driven_loads/load_lines.h"

namespace clevis::mechanism {

/// Chooses the looks of a driven motion that become instants: so many that the
/// loads between two of them lie on the straight line between theirs. Stress is
/// a convex function of the loads, so none is larger between.
class LoadInstants {
 public:
  /// @param scales  outlive this.
  explicit LoadInstants(LoadScales& scales)
      : scales_(scales), trajectory_(scales.trajectory()), lines_(scales) {}

  /// Makes instants of the largest lengths of each load, and then of what lies
  /// off the lines between instants.
  /// @param most  of the latter.
  void choose(std::size_t most);
  /// Chooses more looks, in the order of time, until cubics through chosen ones
  /// and instants follow all loads, also where they are small or repeat those
  /// of another time: what vibrates feels them again.
  /// @param most  looks. @return the time up to which they do [s].
  double follow(std::size_t most);
  /// By body: how much more than at the instants its loads may be between
  /// them, over the largest of their kind [1].
  std::vector<double> unseen();

 private:
  using At = DrivenTrajectory::At;
  void find_peak(const BodyLoads::Vector& vector, Eigen::Index v);
  double look_at_vertex(At top, const BodyLoads::Vector& vector, At& best);
  std::vector<At> instants();
  bool is_covered(const DrivenTrajectory::Look& look,
                  const std::vector<At>& instants) const;

  LoadScales& scales_;
  DrivenTrajectory& trajectory_;
  LoadLines lines_;
};

}  // namespace clevis::mechanism
