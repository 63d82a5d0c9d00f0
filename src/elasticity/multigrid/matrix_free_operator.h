#pragma once

#include <array>
#include <string>
#include <vector>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/lanes/cell_schedule.h"
#include "elasticity/lanes/lane_vector.h"
#include "elasticity/lanes/thread_team.h"

namespace clevis::elasticity {

/// Kernels for the best instruction set that this machine has.
const lanes::Kernels& lane_kernels();

/// y = K x without K: sum factorisation on hexahedra, kLanes columns at once.
///
/// The nodes may be of a lower degree than the discretisation, whose geometry
/// holds on every level. Bit-identical for any number of threads.
template <typename Real>
class MatrixFreeOperator {
 public:
  /// @param points  Gauss points a direction: degree of the nodes + 1 or + 2.
  /// @param held    degrees of freedom of `nodes` (3 node + component) whose
  ///   rows are zero; columns must be zero there.
  /// @param place   of an error, e.g. "part DCE".
  /// @throws Error M005 if the mapping of a cell is not positive at a point.
  MatrixFreeOperator(const Discretization<3>& discretization,
                     const CellSchedule& schedule, const NodeTable& nodes,
                     int points, const LameConstants<3>& lame,
                     std::vector<int> held, ThreadTeam& team,
                     const std::string& place);

  void apply(const LaneVector<Real>& x, LaneVector<Real>& y) const;
  /// Likewise with the held rows: the supports' reactions.
  void apply_to_all(const LaneVector<Real>& x, LaneVector<Real>& y) const;

  /// Diagonal 3 × 3 blocks of K: xx, xy, xz, yy, yz, zz [N/m].
  std::vector<std::array<double, 6>> diagonal() const;

  /// Memory traffic [bytes] of one application if nothing is read twice:
  /// x, y (with the read before a write), node numbers, metric.
  double traffic() const;

 private:
  const CellSchedule& schedule_;
  const NodeTable& nodes_;
  ThreadTeam& team_;
  int points_;
  LameConstants<3> lame_;
  std::vector<int> held_;
  std::vector<Real> interpolation_, derivative_, metric_;
  mutable LaneVector<Real> ghost_;
};

/// Adds what parts kept for nodes of earlier parts, in the parts' order.
template <typename Real>
void add_ghosts(const NodeTable& nodes, const LaneVector<Real>& ghost,
                ThreadTeam& team, LaneVector<Real>& y);

}  // namespace clevis::elasticity
