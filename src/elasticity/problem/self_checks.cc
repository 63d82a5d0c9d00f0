#include "elasticity/problem/self_checks.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/nodal_loads/load_vectors.h"

namespace clevis::elasticity {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Bounds of the self-checks: far above round-off, far below any use.
constexpr double kReliefFaceted = 5e-2;  // geometry of degree 1
constexpr double kRelief = 1e-3;         // of higher degree, on coarse cells
constexpr double kBalance = 1e-12;
constexpr double kEquilibrium = 1e-9;
constexpr double kResidual = 1e-8;
constexpr double kResidualRoundOff = 1e-12;  // of ‖|K| |u|‖
constexpr double kEnergy = 1e-8;
constexpr double kCompression = 1e-6;

/// The larger of both; once NaN, always NaN.
void raise(double& value, double other) {
  if (!(other <= value) && !std::isnan(value)) value = other;
}

ArrayXd column_norms(const MatrixXd& columns) {
  return columns.colwise().norm().transpose().array();
}

void require(double value, double bound, const char* what,
             const std::string& name) {
  if (value <= bound) return;  // NaN falls through
  throw Error(
      "F003", "part " + name,
      fmt::format("self-check {}: {:.2e}, allowed {:.0e}", what, value, bound),
      "Check mesh quality and loads; if they are sound, report this "
      "scene.");
}

/// Rigid modes about the mean of the nodes, of like size.
template <int dim>
MatrixXd modes_of(const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions) {
  const double length =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  return rigid_modes<dim>(positions, positions.rowwise().mean(), length);
}

}  // namespace

template <int dim>
StiffnessAction action_of(const StiffnessMatrix<dim>& stiffness) {
  return {[&stiffness](const MatrixXd& x) {
            return stiffness.multiply(x);
          },
          [&stiffness](const MatrixXd& x) {
            return stiffness.absolute().multiply(x);
          }};
}

template <int dim>
void balance_free_part(
    const Discretization<dim>& discretization,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions, double density,
    MatrixXd& history, SolveChecks& checks) {
  const MatrixXd modes = modes_of<dim>(positions);
  checks.relief = balance_loads(discretization, density, modes, history);
  const double scale = history.cwiseAbs().colwise().sum().maxCoeff();
  if (!(scale > 0.0)) return;
  checks.balance =
      transposed_product(modes, history).cwiseAbs().maxCoeff() / scale;
}

template <int dim>
void balance_free_part(
    const Discretization<dim>& discretization,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions, double density,
    SplitLoads& loads, SolveChecks& checks) {
  const auto balance =
      balance_loads(discretization, density, modes_of<dim>(positions), loads);
  checks.relief = balance.relief;
  checks.balance = balance.rest;
}

void restore_balance(const MatrixXd& modes, MatrixXd& columns) {
  const MatrixXd gram = modes.transpose() * modes;
  columns -=
      product(modes, gram.ldlt().solve(transposed_product(modes, columns)));
}

void forget_solution(SolveChecks& checks) {
  checks.residual = checks.residual_round_off = 0.0;
  checks.equilibrium = checks.equilibrium_round_off = 0.0;
  checks.energy = 0.0;
}

void SolutionCheck::add(const StiffnessAction& stiffness,
                        const MatrixXd& columns, const LoadBasis& loads,
                        const ArrayXd& norms, const std::vector<int>& held,
                        const std::vector<int>& without_reaction, double weight,
                        SolveChecks& checks) {
  if (loads.columns.cols() == 0) return;  // nothing loads it
  const MatrixXd& c = loads.coefficients;
  const MatrixXd forces = stiffness.multiply(columns);
  MatrixXd rest = forces - loads.columns;
  MatrixXd reactions(static_cast<Index>(without_reaction.size()), rest.cols());
  for (std::size_t k = 0; k < without_reaction.size(); ++k) {
    reactions.row(static_cast<Index>(k)) = rest.row(without_reaction[k]);
  }
  for (int row : held) rest.row(row).setZero();
  const double residual = (column_norms(rest) / norms).maxCoeff();
  raise(checks.residual, residual);
  double equilibrium = 0.0;
  if (reactions.rows() > 0) {
    // Per instant: a column of small weight may carry round-off of large ones.
    equilibrium =
        product(reactions, c).colwise().norm().maxCoeff() / largest_load_;
    raise(checks.equilibrium, equilibrium);
  }
  if (!(residual <= kResidual && equilibrium <= kEquilibrium)) {
    // K u of a slender part is a small difference of large terms.
    const MatrixXd terms = stiffness.multiply_absolute(columns.cwiseAbs());
    raise(checks.residual_round_off,
          kResidualRoundOff * (column_norms(terms) / norms).maxCoeff());
    raise(checks.equilibrium_round_off,
          kResidualRoundOff *
              product(terms, c.cwiseAbs()).colwise().norm().maxCoeff() /
              largest_load_);
  }
  // Energies per instant, once with K and once with the loads.
  const auto quadratic = [&](const MatrixXd& form) -> VectorXd {
    return c.cwiseProduct(product(form, c)).colwise().sum().transpose();
  };
  energy_ += weight * quadratic(transposed_product(columns, forces));
  work_ += weight * quadratic(transposed_product(columns, loads.columns));
}

VectorXd SolutionCheck::strain_energy(SolveChecks& checks) const {
  for (Index i = 0; i < work_.size(); ++i) {
    if (work_[i] == 0.0) continue;
    raise(checks.energy, std::abs(energy_[i] - work_[i]) / std::abs(work_[i]));
  }
  return 0.5 * energy_;
}

VectorXd check_solution(const StiffnessAction& stiffness,
                        const MatrixXd& columns, const LoadBasis& loads,
                        const std::vector<int>& held, bool is_free,
                        SolveChecks& checks) {
  forget_solution(checks);
  SolutionCheck check(loads.coefficients.cols(), largest_instant(loads));
  check.add(stiffness, columns, loads, column_norms(loads.columns), held,
            is_free ? held : std::vector<int>(), 1.0, checks);
  return check.strain_energy(checks);
}

bool wants_refinement(const SolveChecks& checks) {
  constexpr double kShare = 0.1;  // round-off differs from one BLAS to another
  return checks.residual > kShare * kResidual ||
         checks.equilibrium > kShare * kEquilibrium ||
         checks.energy > kShare * kEnergy;
}

void require_checks(const SolveChecks& checks, int geometry_degree,
                    const std::string& part_name) {
  require(checks.relief, geometry_degree == 1 ? kReliefFaceted : kRelief,
          "inertia relief", part_name);
  require(checks.balance, kBalance, "balance of loads", part_name);
  require(checks.compression, kCompression, "load compression", part_name);
  require(checks.residual, std::max(kResidual, checks.residual_round_off),
          "residual", part_name);
  require(checks.equilibrium,
          std::max(kEquilibrium, checks.equilibrium_round_off),
          "support reactions", part_name);
  require(checks.energy, kEnergy, "energy", part_name);
}

#define CLEVIS_INSTANTIATE(dim)                                               \
  template StiffnessAction action_of<dim>(const StiffnessMatrix<dim>&);       \
  template void balance_free_part<dim>(                                       \
      const Discretization<dim>&,                                             \
      const Eigen::Matrix<double, dim, Eigen::Dynamic>&, double, MatrixXd&,   \
      SolveChecks&);                                                          \
  template void balance_free_part<dim>(                                       \
      const Discretization<dim>&,                                             \
      const Eigen::Matrix<double, dim, Eigen::Dynamic>&, double, SplitLoads&, \
      SolveChecks&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
