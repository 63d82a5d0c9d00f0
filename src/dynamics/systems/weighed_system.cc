#include "dynamics/systems/weighed_system.h"

#include <Eigen/Cholesky>

namespace clevis::dynamics {

using Eigen::MatrixXd;

LinearSystem weighed_system(const LinearSystem& system,
                            const MatrixXd& weights) {
  LinearSystem weighed = system;
  weighed.mass = [mass = system.mass, weights](const MatrixXd& x) -> MatrixXd {
    return mass(x) + weights * (weights.transpose() * x);
  };
  weighed.factor = [factor = system.factor, stiffness = system.stiffness,
                    mass = weighed.mass,
                    weights](double shift) -> BlockOperator {
    const BlockOperator solve = factor(shift);
    if (shift == 0.0) return solve;
    const MatrixXd answers = solve(weights);
    MatrixXd between = weights.transpose() * answers;
    between.diagonal().array() += 1.0 / shift;
    const Eigen::LLT<MatrixXd> inner(between);
    const auto once = [solve, answers, inner, weights](const MatrixXd& b) {
      MatrixXd x = solve(b);
      x -= answers * inner.solve(weights.transpose() * x);
      return x;
    };
    return [once, stiffness, mass, shift](const MatrixXd& b) -> MatrixXd {
      MatrixXd x = once(b);
      // Heavy masses leave little of a rigid motion that is large in `solve`.
      x += once(b - stiffness(x) - shift * mass(x));
      return x;
    };
  };
  return weighed;
}

}  // namespace clevis::dynamics
