#include "machine/transmissions/chain_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace clevis::machine {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Chain {
  std::vector<double> inertias, compliances;
};

/// The same without masses of zero and without rigid springs.
Chain condensed(const std::vector<double>& inertias,
                const std::vector<double>& compliances) {
  Chain chain{{inertias.front()}, {}};
  double between = 0.0;
  for (std::size_t k = 1; k < inertias.size(); ++k) {
    between += compliances[k - 1];
    if (inertias[k] <= 0.0) continue;
    if (between > 0.0) {
      chain.compliances.push_back(between);
      chain.inertias.push_back(inertias[k]);
    } else {
      chain.inertias.back() += inertias[k];
    }
    between = 0.0;
  }
  return chain;
}

/// Of masses from `first` on; the springs of those before hold them.
std::vector<double> frequencies(const Chain& chain, std::size_t first) {
  const auto n = static_cast<Index>(chain.inertias.size() - first);
  if (n < 1) return {};
  VectorXd diagonal = VectorXd::Zero(n), beside = VectorXd::Zero(n - 1);
  for (std::size_t k = 0; k < chain.compliances.size(); ++k) {
    const double stiffness = 1.0 / chain.compliances[k];
    const Index i = static_cast<Index>(k) - static_cast<Index>(first);
    if (i >= 0) diagonal[i] += stiffness / chain.inertias[k];
    if (i + 1 >= 0) diagonal[i + 1] += stiffness / chain.inertias[k + 1];
    if (i >= 0) {
      beside[i] =
          -stiffness / std::sqrt(chain.inertias[k] * chain.inertias[k + 1]);
    }
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  std::vector<double> result;
  // without a hold the first is the motion as a whole
  for (Index i = first == 0 ? 1 : 0; i < n; ++i) {
    result.push_back(std::sqrt(std::max(0.0, solver.eigenvalues()[i])) /
                     (2.0 * std::numbers::pi));
  }
  return result;
}

}  // namespace

ChainModel chain_model(const std::vector<double>& inertias,
                       const std::vector<double>& compliances) {
  const Chain chain = condensed(inertias, compliances);
  return {frequencies(chain, 0), frequencies(chain, 1)};
}

}  // namespace clevis::machine
