#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mechanism/driven_search/driven_trajectory.h"

namespace clevis::mechanism {

/// Looks at the loads of a driven motion between events until they are smooth
/// from look to look, and chooses the looks that become instants: so many that
/// the loads between two of them lie on the straight line between theirs.
/// Stress is a convex function of the loads, so none is larger between.
class LoadTrajectory {
 public:
  /// @param beside  whether rigid reactions grow without bound about a time
  ///   [s].
  LoadTrajectory(DrivenTrajectory& trajectory,
                 std::function<bool(double)> beside);

  /// Looks until the cubic through the neighbours of each look meets it.
  /// @param most  looks. @return whether that was enough.
  bool refine(std::size_t most);
  /// Makes instants of the largest lengths of each load, and then of what lies
  /// off the lines between instants.
  /// @param most  of the latter.
  void choose(std::size_t most);
  /// Chooses more looks, in the order of time, until the loads between chosen
  /// ones and instants lie on lines also where they repeat those of another
  /// time: what vibrates feels them again.
  /// @param most  looks. @return the time up to which they do [s].
  double follow(std::size_t most);
  /// By body: how much more than at the instants its loads may be between
  /// them, over the largest of their kind [1].
  std::vector<double> unseen();
  /// The latest time up to which refine() came [s].
  double ended_at() const { return ended_at_; }

 private:
  using At = DrivenTrajectory::At;
  using Piece = std::vector<At>;  ///< looks between which loads are smooth
  void note(const DrivenTrajectory::Look& look);
  void note_all();
  std::vector<Piece> pieces();
  bool refine_piece(Piece piece, std::size_t most);
  std::vector<std::size_t> unresolved(const Piece& piece) const;
  void find_peak(const BodyLoads::Vector& vector, Eigen::Index v);
  double look_at_vertex(At top, const BodyLoads::Vector& vector, At& best);

  /// Between two instants: the look that lies farthest off their line.
  struct Gap {
    At left, right, worst;
    double defect = 0.0;  ///< over the scale of its kind [1]
    bool operator<(const Gap& other) const { return defect < other.defect; }
  };
  Eigen::VectorXd levels(At left, At right) const;
  Eigen::VectorXd off_line(const Eigen::VectorXd& loads, double t, At left,
                           At right) const;
  std::optional<Eigen::VectorXd> middle_by_cubic(At left, At right) const;
  bool is_closed(At left, At right) const;
  Gap gap(At left, At right, bool repeats_count = false) const;
  std::vector<At> instants();
  bool is_covered(const DrivenTrajectory::Look& look,
                  const std::vector<At>& instants) const;

  DrivenTrajectory& trajectory_;
  const BodyLoads& loads_;
  std::function<bool(double)> beside_;
  Eigen::VectorXd largest_, scales_;
  Eigen::VectorXd inverse_;  ///< 1 / scale, by number
  double ended_at_ = 0.0;
};

}  // namespace clevis::mechanism
