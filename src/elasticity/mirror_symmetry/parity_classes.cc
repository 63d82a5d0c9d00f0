#include "elasticity/mirror_symmetry/parity_classes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/supports.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

constexpr double kLoadless = 1e-8;  // a class, against the whole

/// Rigid modes of the folded part that belong to a class.
template <int dim>
MatrixXd free_modes(const Folding<dim>& folding, unsigned parity,
                    const Positions<dim>& positions) {
  const Eigen::Matrix<double, dim, 1> low = positions.rowwise().minCoeff();
  const Eigen::Matrix<double, dim, 1> high = positions.rowwise().maxCoeff();
  Eigen::Matrix<double, dim, 1> centre = 0.5 * (low + high);
  for (const Mirror& mirror : folding.mirrors) {
    centre[mirror.axis] = mirror.position;
  }
  const MatrixXd all = rigid_modes<dim>(positions, centre, (high - low).norm());
  const std::vector<int> belong = rigid_modes_of(folding, parity);
  MatrixXd modes(all.rows(), static_cast<Index>(belong.size()));
  for (std::size_t k = 0; k < belong.size(); ++k) {
    modes.col(static_cast<Index>(k)) = all.col(belong[k]);
  }
  return modes;
}

/// Takes out of a class's loads what leaves them out of balance on the folded
/// part: the mesh is symmetric to 1e-9 only, its nodes have moved so far.
void balance_class(const MatrixXd& modes, MatrixXd& loads) {
  if (modes.cols() == 0) return;
  loads -= product(modes, (modes.transpose() * modes)
                              .llt()
                              .solve(transposed_product(modes, loads)));
}

}  // namespace

template <int dim>
std::vector<Mirror> common_mirrors(const Discretization<dim>& discretization,
                                   const Positions<dim>& positions,
                                   const std::vector<int>& fixed) {
  std::vector<Mirror> mirrors = find_mirrors<dim>(discretization, positions);
  std::erase_if(mirrors, [&](const Mirror& mirror) {
    return !maps_to_itself<dim>(mirror, fixed);
  });
  return mirrors;
}

template <int dim>
void hold(const Folding<dim>& folding, const std::vector<int>& fixed,
          const Positions<dim>& folded_positions, ParityClass& parity_class) {
  std::vector<int>& held = parity_class.held;
  held = held_on_planes(folding, parity_class.parity);
  if (fixed.empty()) {
    parity_class.supports = determinate_supports(
        folding.part,
        free_modes<dim>(folding, parity_class.parity, folded_positions), held);
    held.insert(held.end(), parity_class.supports.begin(),
                parity_class.supports.end());
  }
  for (int dof : fixed) {
    held.push_back(dim * folding.node[static_cast<std::size_t>(dof / dim)] +
                   dof % dim);
  }
  std::ranges::sort(held);
  held.erase(std::unique(held.begin(), held.end()), held.end());
}

template <int dim>
std::vector<ParityClass> loaded_classes(const Folding<dim>& folding,
                                        const Positions<dim>& folded_positions,
                                        const LoadBasis& loads, bool is_free,
                                        double& error) {
  std::vector<ParityClass> classes;
  if (loads.columns.cols() == 0) return classes;
  const double scale = largest_instant(loads) /
                       std::sqrt(static_cast<double>(folding.classes()));
  for (unsigned parity = 0; parity < folding.classes(); ++parity) {
    LoadBasis folded{loads_of_class(folding, parity, loads.columns),
                     loads.coefficients};
    const double size = largest_instant(folded) / scale;
    if (size <= kLoadless) {
      error = std::hypot(error, size);
      continue;
    }
    if (is_free && folding.classes() > 1) {
      balance_class(free_modes<dim>(folding, parity, folded_positions),
                    folded.columns);
    }
    classes.emplace_back();
    classes.back().parity = parity;
    classes.back().loads = std::move(folded);
  }
  return classes;
}

Eigen::VectorXd check_classes(const StiffnessAction& stiffness,
                              const std::vector<ParityClass>& classes,
                              double images, const LoadBasis& loads,
                              SolveChecks& checks) {
  forget_solution(checks);
  const double share = 1.0 / std::sqrt(images);
  SolutionCheck check(loads.coefficients.cols(),
                      share * largest_instant(loads));
  const Eigen::ArrayXd norms =
      share * loads.columns.colwise().norm().transpose().array();
  for (const ParityClass& c : classes) {
    check.add(stiffness, c.columns, c.loads, norms, c.held, c.supports, images,
              checks);
  }
  return check.strain_energy(checks);
}

template std::vector<Mirror> common_mirrors<2>(const Discretization<2>&,
                                               const Positions<2>&,
                                               const std::vector<int>&);
template void hold<2>(const Folding<2>&, const std::vector<int>&,
                      const Positions<2>&, ParityClass&);
template std::vector<ParityClass> loaded_classes<2>(const Folding<2>&,
                                                    const Positions<2>&,
                                                    const LoadBasis&, bool,
                                                    double&);
template std::vector<Mirror> common_mirrors<3>(const Discretization<3>&,
                                               const Positions<3>&,
                                               const std::vector<int>&);
template void hold<3>(const Folding<3>&, const std::vector<int>&,
                      const Positions<3>&, ParityClass&);
template std::vector<ParityClass> loaded_classes<3>(const Folding<3>&,
                                                    const Positions<3>&,
                                                    const LoadBasis&, bool,
                                                    double&);

}  // namespace clevis::elasticity
