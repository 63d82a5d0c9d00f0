#include "dynamics/systems/weighed_system.h"

#include "dynamics/systems/updated_factor.h"

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
    return updated_factor(solve, weights, shift,
                          [stiffness, mass, shift](const MatrixXd& x) {
                            return MatrixXd(stiffness(x) + shift * mass(x));
                          });
  };
  return weighed;
}

}  // namespace clevis::dynamics
