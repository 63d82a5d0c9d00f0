#include "stress/zones/zone_strength.h"

#include <algorithm>
#include <cmath>

#include "stress/field/cell_field.h"

namespace clevis::stress {
namespace {

/// Twice the strain energy of cells at one instant, times Young's modulus.
template <int dim>
class StrainEnergy {
 public:
  StrainEnergy(const elasticity::DisplacementBasis<dim>& basis,
               const part::Material& material, int instant)
      : discretization_(basis.discretization),
        rule_(elasticity::gauss<dim>(discretization_.shape,
                                     {discretization_.degree + 1,
                                      discretization_.thickness_degree + 1})),
        geometry_(discretization_.shape, discretization_.mapping_degree(),
                  rule_.points),
        field_(discretization_, material, rule_.points),
        nu_(material.poissons_ratio),
        u_(basis.columns * basis.coefficients.col(instant)) {}

  double over(const std::vector<int>& cells) const {
    double sum = 0.0;
    for (const int cell : cells) {
      const auto c = static_cast<std::size_t>(cell);
      const auto at = elasticity::cell_geometry<dim>(
          discretization_.cell_points[c], geometry_);
      sum += density(field_.stress(c, u_))
                 .cwiseProduct(at.determinant)
                 .dot(rule_.weights);
    }
    return sum;
  }

 private:
  /// (1 + ν) σ:σ − ν (tr σ)², point by point.
  Eigen::VectorXd density(const Eigen::MatrixXd& stress) const {
    const Eigen::Index n = rule_.weights.size();
    Eigen::ArrayXd trace = Eigen::ArrayXd::Zero(n);
    Eigen::ArrayXd squares = Eigen::ArrayXd::Zero(n);
    for (int k = 0; k < kStressComponents<dim>; ++k) {
      const auto component = stress.middleRows(k * n, n).array();
      if (k < dim) trace += component;
      squares += (k < dim ? 1.0 : 2.0) * component.square();
    }
    return (1.0 + nu_) * squares - nu_ * trace.square();
  }

  const elasticity::Discretization<dim>& discretization_;
  elasticity::Quadrature<dim> rule_;
  elasticity::CellInterpolation<dim> geometry_;
  CellField<dim> field_;
  double nu_;
  Eigen::MatrixXd u_;
};

/// Slope of y over 0, 1, 2 …
double slope(const std::vector<double>& y) {
  const auto n = static_cast<double>(y.size());
  double above = 0.0;
  double below = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double x = static_cast<double>(i) - 0.5 * (n - 1.0);
    above += x * y[i];
    below += x * x;
  }
  return above / below;
}

}  // namespace

std::vector<std::vector<int>> rings_of(const mesh::GradedMesh& graded,
                                       std::size_t vertex) {
  std::vector<std::vector<int>> rings;
  for (std::size_t c = 0; c < graded.ring.size(); ++c) {
    if (graded.vertex_of[c] != static_cast<int>(vertex)) continue;
    const auto k = static_cast<std::size_t>(graded.ring[c]);
    if (rings.size() <= k) rings.resize(k + 1);
    rings[k].push_back(static_cast<int>(c));
  }
  return rings;
}

template <int dim>
ZoneStrength zone_strength(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material,
                           const StressHistory& history,
                           const std::vector<std::vector<int>>& rings) {
  const std::size_t last = rings.size() - 2;  // beside the vertex's cells
  ZoneStrength strength;
  int instant = 0;
  for (const int cell : rings[last]) {
    Eigen::Index point = 0;
    const double worst = history.worst.col(cell).maxCoeff(&point);
    if (worst <= strength.innermost) continue;
    strength.innermost = worst;
    instant = history.worst_instant(point, cell);
  }
  if (strength.innermost == 0.0) return strength;
  const StrainEnergy<dim> energy(basis, material, instant);
  std::vector<double> logarithms;
  for (std::size_t k = rings.size() / 2 - 1; k < last; ++k) {
    logarithms.push_back(std::log(energy.over(rings[k])));
  }
  strength.exponent = slope(logarithms) / (2.0 * std::log(mesh::kGradingRatio));
  return strength;
}

template ZoneStrength zone_strength<2>(const elasticity::DisplacementBasis<2>&,
                                       const part::Material&,
                                       const StressHistory&,
                                       const std::vector<std::vector<int>>&);
template ZoneStrength zone_strength<3>(const elasticity::DisplacementBasis<3>&,
                                       const part::Material&,
                                       const StressHistory&,
                                       const std::vector<std::vector<int>>&);

}  // namespace clevis::stress
