#include "assessment/vibration/vibrating_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stress/field/stress_history.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kSides = 1e-8;  // of the motion: both sides of an event
constexpr int kTimes = 2400;
constexpr double kPerPeriod = 400.0;  // times of the lowest shape's

template <int dim>
constexpr int kSubdivisions = dim == 2 ? 4 : 2;

/// Every n-th time.
template <int dim>
elasticity::DisplacementBasis<dim> every(
    Index n, const elasticity::DisplacementBasis<dim>& all) {
  elasticity::DisplacementBasis<dim> some;
  some.discretization = all.discretization;
  some.columns = all.columns;
  const Index count = (all.coefficients.cols() + n - 1) / n;
  some.coefficients =
      all.coefficients(Eigen::all, Eigen::seqN(Index{0}, count, n));
  return some;
}

/// Without the other cells; groups keep the numbers of the whole and are not
/// to be asked for.
template <int dim>
elasticity::DisplacementBasis<dim> within(
    const std::vector<int>& cells,
    const elasticity::DisplacementBasis<dim>& all) {
  elasticity::DisplacementBasis<dim> some = all;
  auto& part = some.discretization;
  part.cell_nodes.clear();
  part.cell_points.clear();
  for (const int c : cells) {
    const auto cell = static_cast<std::size_t>(c);
    part.cell_nodes.push_back(all.discretization.cell_nodes[cell]);
    part.cell_points.push_back(all.discretization.cell_points[cell]);
  }
  return some;
}

}  // namespace

template <int dim>
VibratingModel<dim>::VibratingModel(const PartJob& job,
                                    const mesh::PartMesh<dim>& mesh,
                                    const LoadSet& set, int degree,
                                    const std::vector<VibrationWindow>& windows)
    : job_(job),
      set_(set),
      windows_(windows),
      part_({mesh, job.part.material, set.history, {}, job.part.name}, degree,
            instants_within(windows, set.history.instants)),
      zones_(stress::singular_zones<dim>(mesh, job.part.material, {})),
      path_(make_path()),
      still_(peak_of(part_.statics()).value) {}

template <int dim>
dynamics::LoadPath VibratingModel<dim>::make_path() const {
  const auto& instants = set_.history.instants;
  VectorXd time(static_cast<Index>(instants.size()));
  for (Index i = 0; i < time.size(); ++i) {
    time[i] = instants[static_cast<std::size_t>(i)].time;
  }
  return {time, part_.statics().coefficients,
          kSides * (time[time.size() - 1] - time[0])};
}

template <int dim>
stress::PartialPeak VibratingModel<dim>::peak_of(const Basis& basis) const {
  const auto history = stress::stress_history<dim>(basis, job_.part.material,
                                                   kSubdivisions<dim>);
  const auto zone_of = stress::zone_of_points<dim>(basis.discretization,
                                                   kSubdivisions<dim>, zones_);
  return stress::peak_outside(history, zone_of,
                              std::vector<bool>(zones_.size(), true), dim);
}

template <int dim>
std::vector<int> VibratingModel<dim>::cells_near_peak(
    const Basis& basis) const {
  constexpr Index kSixth = 6;
  constexpr double kNear = 0.75;
  const auto zone_of = stress::zone_of_points<dim>(basis.discretization,
                                                   kSubdivisions<dim>, zones_);
  const auto coarse = stress::stress_history<dim>(
      every<dim>(kSixth, basis), job_.part.material, kSubdivisions<dim>);
  const Eigen::ArrayXXd outside =
      (zone_of.array() >= 0).select(0.0, coarse.worst.array());
  std::vector<int> cells;
  for (Index c = 0; c < outside.cols(); ++c) {
    if (outside.col(c).maxCoeff() >= kNear * outside.maxCoeff()) {
      cells.push_back(static_cast<int>(c));
    }
  }
  return cells;
}

template <int dim>
elasticity::DisplacementBasis<dim> VibratingModel<dim>::basis_of(
    const typename elasticity::LoadVibration<dim>::Shapes& shapes,
    const dynamics::LoadAnswer& moving) const {
  const auto& still = part_.statics();
  Basis basis;
  basis.discretization = still.discretization;
  basis.columns.resize(still.columns.rows(),
                       still.columns.cols() + shapes.columns.cols());
  basis.columns << still.columns, shapes.columns;
  basis.coefficients.resize(basis.columns.cols(), moving.time.size());
  basis.coefficients << moving.path, moving.added;
  basis.strain_energy = VectorXd::Zero(moving.time.size());
  return basis;
}

template <int dim>
VibratingAnswer<dim> VibratingModel<dim>::answer(
    int count, const dynamics::LoadPath& path) {
  const auto shapes = part_.shapes(count);
  const VectorXd hertz = shapes.squares.cwiseSqrt() / (2.0 * std::numbers::pi);
  VibratingAnswer<dim> found;
  found.shapes = static_cast<int>(hertz.size());
  found.lowest = hertz.minCoeff();
  found.highest = hertz.maxCoeff();
  const auto answer_at = [&](const VectorXd& times) {
    return dynamics::answer_to(path, shapes.participation, shapes.squares,
                               job_.part.damping, times);
  };
  const VectorXd even =
      times_within(windows_, 1.0 / (kPerPeriod * found.lowest), kTimes);
  auto moving = answer_at(even);
  found.basis = basis_of(shapes, moving);
  const std::vector<int> cells = cells_near_peak(found.basis);
  const auto looked = stress::stress_history<dim>(
      within<dim>(cells, found.basis), job_.part.material, kSubdivisions<dim>);
  moving = answer_at(
      with_times_near_peaks(even, moving.time, looked.peak, windows_));
  found.basis = basis_of(shapes, moving);
  const Basis near = within<dim>(cells, found.basis);
  found.peak = peak_of(near);
  found.sampling_error =
      (1.0 - peak_of(every<dim>(2, near)).value / found.peak.value) / 3.0;
  found.peak.at.cell = cells[static_cast<std::size_t>(found.peak.at.cell)];
  found.time = moving.time[found.peak.instant];
  found.at = stress::position<dim>(found.basis.discretization, found.peak.at,
                                   kSubdivisions<dim>);
  found.group = stress::surface_group<dim>(found.basis.discretization,
                                           found.peak.at, kSubdivisions<dim>);
  return found;
}

template class VibratingModel<2>;
template class VibratingModel<3>;

}  // namespace clevis::assessment
