#include "elasticity/vibration/neighbour_hold.h"

#include <cstddef>

#include "base/algebra/singular_vectors.h"
#include "elasticity/nodal_loads/seat_means.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kWrench = 6;

template <int dim>
MatrixXd acting_rows(const MatrixXd& wrenches) {
  const Index seats = wrenches.rows() / kWrench;
  const auto width = static_cast<Index>(kActing<dim>.size());
  MatrixXd rows(width * seats, wrenches.cols());
  for (Index s = 0; s < seats; ++s) {
    for (Index k = 0; k < width; ++k) {
      rows.row(width * s + k) =
          wrenches.row(kWrench * s + kActing<dim>[static_cast<std::size_t>(k)]);
    }
  }
  return rows;
}

/// A with A Aᵀ the same and columns that are orthogonal, none of round-off.
MatrixXd principal(const MatrixXd& columns) {
  constexpr double kRoundOff = 1e-9;
  const SingularVectors found = singular_vectors(columns);
  const Index rank = found.rank(kRoundOff);
  return found.U.leftCols(rank) * found.sigma.head(rank).asDiagonal();
}

/// With other bodies that springs swing.
template <int dim>
NeighbourHold with_bodies(const loads::SwingingBodies& swinging,
                          const MatrixXd& means) {
  const Index bodies = swinging.followed.rows();
  const auto nodal = [&](const MatrixXd& wrenches,
                         const MatrixXd& there) -> MatrixXd {
    const MatrixXd rows = acting_rows<dim>(wrenches);
    MatrixXd both(rows.rows() + bodies, rows.cols());
    both << rows, there;
    both = principal(both);
    MatrixXd found(means.rows() + bodies, both.cols());
    found << means * both.topRows(rows.rows()), both.bottomRows(bodies);
    return found;
  };
  return {.held = nodal(swinging.held, swinging.followed),
          .weighed = MatrixXd(means.rows() + bodies, 0),
          .sprung = nodal(swinging.sprung, swinging.sprung_there),
          .damped = nodal(swinging.damped, swinging.damped_there),
          .bodies = bodies};
}

}  // namespace

template <int dim>
NeighbourHold neighbour_hold(const Discretization<dim>& discretization,
                             const loads::LoadHistory& history,
                             const std::string& part_name) {
  const MatrixXd none(discretization.dofs(), 0);
  if (!history.hold) return {none, none, none, none};
  const loads::SeatHold hold = history.hold_that_counts();
  if (hold.swinging) {
    return with_bodies<dim>(
        *hold.swinging,
        seat_means(discretization, history.seats, hold.zones, part_name));
  }
  const auto acting = [](const MatrixXd& wrenches) {
    return principal(acting_rows<dim>(wrenches));
  };
  const MatrixXd held = acting(hold.held), weighed = acting(hold.weighed);
  const MatrixXd sprung = acting(hold.sprung), damped = acting(hold.damped);
  if (held.cols() + weighed.cols() + sprung.cols() + damped.cols() == 0) {
    return {none, none, none, none};
  }
  const MatrixXd means =
      seat_means(discretization, history.seats, hold.zones, part_name);
  const auto nodal = [&](const MatrixXd& wrenches) -> MatrixXd {
    return wrenches.cols() > 0 ? MatrixXd(means * wrenches) : none;
  };
  return {nodal(held), nodal(weighed), nodal(sprung), nodal(damped)};
}

template NeighbourHold neighbour_hold<2>(const Discretization<2>&,
                                         const loads::LoadHistory&,
                                         const std::string&);
template NeighbourHold neighbour_hold<3>(const Discretization<3>&,
                                         const loads::LoadHistory&,
                                         const std::string&);

}  // namespace clevis::elasticity
