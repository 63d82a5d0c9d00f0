#include "stress/displacement/held_reference.h"

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/supports.h"
#include "loads/history/motion_instants.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
elasticity::PinHold<dim> pin_hold(
    elasticity::MeanMotions<dim>& motions, const loads::PartHold& hold,
    std::optional<elasticity::TouchedSeats> touched = {}) {
  return {motions,
          {.groups = hold.groups,
           .touched = std::move(touched),
           .held = hold.held,
           .sprung = hold.sprung}};
}

/// Of the motion's instants; none where all are alike.
std::vector<loads::PartHold> changing_holds(
    const loads::LoadHistory& history, const loads::HoldingGroups& groups) {
  constexpr std::size_t kLooks = 16;
  const std::size_t motion = loads::motion_length(history);
  if (!history.hold || motion < 2) return {};
  const auto hold = [&](std::size_t i) {
    return loads::reference_at(history, groups, history.instants[i].time);
  };
  const auto first = loads::reference_at(history, groups, history.hold_time);
  const auto is_other = [&](const loads::PartHold& here) {
    return !loads::are_alike(here, first);
  };
  bool changes = false;
  for (std::size_t k = 0; k <= kLooks && !changes; ++k) {
    changes = is_other(hold(k * (motion - 1) / kLooks));
  }
  std::vector<loads::PartHold> holds;
  for (std::size_t i = 0; i < motion && changes; ++i) holds.push_back(hold(i));
  return holds;
}

}  // namespace

template <int dim>
void remove_rigid_motion(elasticity::DisplacementBasis<dim>& basis,
                         const loads::PartHold& hold,
                         std::optional<elasticity::TouchedSeats> touched) {
  elasticity::MeanMotions<dim> motions(basis.discretization);
  basis.columns =
      pin_hold(motions, hold, std::move(touched)).project(basis.columns);
}

template <int dim>
void add_rigid_motions(const MatrixXd& rigid, const MatrixXd& amounts,
                       elasticity::DisplacementBasis<dim>& basis) {
  const Index motions = rigid.cols(), rank = basis.columns.cols();
  basis.columns.conservativeResize(Eigen::NoChange, rank + motions);
  basis.columns.rightCols(motions) = rigid;
  basis.coefficients.conservativeResize(rank + motions, Eigen::NoChange);
  basis.coefficients.bottomRows(motions) = amounts;
  basis.is_mirrored = false;
}

template <int dim>
void refer_to_instants(const loads::LoadHistory& history,
                       const loads::HoldingGroups& groups,
                       elasticity::DisplacementBasis<dim>& basis) {
  constexpr Index kMotions = elasticity::kRigidModes<dim>;
  if (basis.columns.cols() == 0 || basis.discretization.is_revolved) return;
  const auto holds = changing_holds(history, groups);
  if (holds.empty()) return;
  elasticity::MeanMotions<dim> motions(basis.discretization);
  MatrixXd moved = MatrixXd::Zero(kMotions, basis.coefficients.cols());
  for (std::size_t i = 0; i < holds.size(); ++i) {
    const auto at = static_cast<Index>(i);
    moved.col(at) = -pin_hold(motions, holds[i]).broken(basis.columns) *
                    basis.coefficients.col(at);
  }
  add_rigid_motions(motions.rigid(), moved, basis);
}

template void remove_rigid_motion<2>(elasticity::DisplacementBasis<2>&,
                                     const loads::PartHold&,
                                     std::optional<elasticity::TouchedSeats>);
template void remove_rigid_motion<3>(elasticity::DisplacementBasis<3>&,
                                     const loads::PartHold&,
                                     std::optional<elasticity::TouchedSeats>);
template void add_rigid_motions<3>(const MatrixXd&, const MatrixXd&,
                                   elasticity::DisplacementBasis<3>&);
template void refer_to_instants<2>(const loads::LoadHistory&,
                                   const loads::HoldingGroups&,
                                   elasticity::DisplacementBasis<2>&);
template void refer_to_instants<3>(const loads::LoadHistory&,
                                   const loads::HoldingGroups&,
                                   elasticity::DisplacementBasis<3>&);

}  // namespace clevis::stress
