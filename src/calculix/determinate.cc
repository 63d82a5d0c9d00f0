#include "calculix/determinate.h"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "base/messages/errors.h"
#include "elasticity/problem/elastic_problem.h"

namespace clevis::calculix {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::vector<int> fixed_dofs(const elasticity::Discretization<3>& discretization,
                            const elasticity::ElasticProblem<3>& problem) {
  std::vector<int> held;
  for (std::size_t g = 0; g < discretization.groups.size(); ++g) {
    const auto entry = problem.fixed.find(discretization.groups[g].name);
    if (entry == problem.fixed.end()) continue;
    for (const int node :
         elasticity::group_nodes(discretization, static_cast<int>(g))) {
      for (int d = 0; d < 3; ++d) {
        if (entry->second[static_cast<std::size_t>(d)]) {
          held.push_back(3 * node + d);
        }
      }
    }
  }
  std::ranges::sort(held);
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

/// The rigid modes that held components and beds leave, as combinations of all.
MatrixXd free_modes(const MatrixXd& modes, const std::vector<int>& held,
                    const elasticity::FoundationStiffness<3>& beds) {
  constexpr double kLoose = 1e-9;
  MatrixXd gram = MatrixXd::Zero(modes.cols(), modes.cols());
  for (const int dof : held) {
    gram += modes.row(dof).transpose() * modes.row(dof) /
            static_cast<double>(held.size());
  }
  if (!beds.empty()) {
    const MatrixXd bedded = beds.on_modes(modes);
    gram += bedded / bedded.trace() * modes.squaredNorm() /
            static_cast<double>(modes.rows());
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  const Index count = (eigen.eigenvalues().array() <= kLoose).count();
  return eigen.eigenvectors().leftCols(count);
}

}  // namespace

std::vector<int> determinate_dofs(
    const elasticity::Discretization<3>& discretization,
    const elasticity::ElasticProblem<3>& problem,
    const elasticity::FoundationStiffness<3>& beds, const MatrixXd& modes,
    const MatrixXd& loads) {
  constexpr double kBalanced = 1e-9;
  std::vector<int> held = fixed_dofs(discretization, problem);
  const MatrixXd loose = modes * free_modes(modes, held, beds);
  if (loose.cols() == 0) return held;
  const double scale = loads.cwiseAbs().colwise().sum().maxCoeff();
  if ((loose.transpose() * loads).cwiseAbs().maxCoeff() > kBalanced * scale) {
    throw Error("F001", "part " + problem.name,
                "the supports leave the part free to follow its loads",
                "Hold more components in `fixed`.");
  }
  std::vector<int> candidates;
  for (const int node : discretization.vertex_nodes) {
    for (int d = 0; d < 3 && node >= 0; ++d) candidates.push_back(3 * node + d);
  }
  const MatrixXd rows = loose(candidates, Eigen::all);
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.transpose());
  for (Index k = 0; k < loose.cols(); ++k) {
    held.push_back(candidates[static_cast<std::size_t>(
        qr.colsPermutation().indices()[k])]);
  }
  std::ranges::sort(held);
  return held;
}

}  // namespace clevis::calculix
