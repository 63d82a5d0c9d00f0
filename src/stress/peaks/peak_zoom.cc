#include "stress/peaks/peak_zoom.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "elasticity/fe_space/tabulation.h"
#include "stress/field/cell_field.h"
#include "stress/peaks/surroundings.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
using Reference = Eigen::Matrix<double, dim, 1>;

/// Von Mises [Pa] of the stress blocks of CellField at n points.
template <int dim>
Eigen::VectorXd von_mises_of(const MatrixXd& blocks, Index n) {
  MatrixXd stress = MatrixXd::Zero(n, 6);
  for (int k = 0; k < kStressComponents<dim>; ++k) {
    stress.col(dim == 2 && k == 2 ? 3 : k) = blocks.middleRows(k * n, n);
  }
  return von_mises(stress);
}

/// Climbs from a lattice point to the maximum beside it.
template <int dim>
double climb(const elasticity::DisplacementBasis<dim>& basis,
             const part::Material& material, std::size_t cell,
             const MatrixXd& displacement, Reference<dim> at, double spacing) {
  constexpr int kRounds = 4;
  double best = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    spacing *= 0.5;
    const auto points =
        surroundings<dim>(basis.discretization.shape, at, spacing);
    const CellField<dim> field(basis.discretization, material, points);
    const auto values =
        von_mises_of<dim>(field.stress(cell, displacement), points.cols());
    Index highest = 0;
    best = std::max(best, values.maxCoeff(&highest));
    at = points.col(highest);
  }
  return best;
}

}  // namespace

template <int dim>
double field_maximum(const elasticity::DisplacementBasis<dim>& basis,
                     const part::Material& material,
                     const StressHistory& history) {
  constexpr double kNear = 0.95;
  constexpr std::size_t kMost = 16;
  std::vector<std::pair<double, FieldPoint>> candidates;
  const double peak = history.largest();
  for (Index c = 0; c < history.worst.cols(); ++c) {
    Index point = 0;
    const double highest = history.worst.col(c).maxCoeff(&point);
    if (highest < kNear * peak) continue;
    candidates.push_back(
        {highest, {static_cast<int>(c), static_cast<int>(point)}});
  }
  std::ranges::stable_sort(candidates, std::greater{},
                           &std::pair<double, FieldPoint>::first);
  candidates.resize(std::min(candidates.size(), kMost));
  const auto lattice = elasticity::lattice<dim>(basis.discretization.shape,
                                                history.subdivisions);
  double largest = peak;
  for (const auto& candidate : candidates) {
    const FieldPoint& at = candidate.second;
    const int instant = history.worst_instant(at.point, at.cell);
    const MatrixXd u = basis.columns * basis.coefficients.col(instant);
    largest = std::max(
        largest,
        climb<dim>(basis, material, static_cast<std::size_t>(at.cell), u,
                   lattice.col(at.point), 1.0 / history.subdivisions));
  }
  return largest;
}

template double field_maximum<2>(const elasticity::DisplacementBasis<2>&,
                                 const part::Material&, const StressHistory&);
template double field_maximum<3>(const elasticity::DisplacementBasis<3>&,
                                 const part::Material&, const StressHistory&);

}  // namespace clevis::stress
