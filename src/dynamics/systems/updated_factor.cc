#include "dynamics/systems/updated_factor.h"

#include <Eigen/Cholesky>

namespace clevis::dynamics {

using Eigen::MatrixXd;

BlockOperator updated_factor(const BlockOperator& solve,
                             const MatrixXd& columns, double weight,
                             const BlockOperator& product) {
  const MatrixXd answers = solve(columns);
  MatrixXd between = columns.transpose() * answers;
  between.diagonal().array() += 1.0 / weight;
  const Eigen::LLT<MatrixXd> inner(between);
  const auto once = [solve, answers, inner, columns](const MatrixXd& b) {
    MatrixXd x = solve(b);
    x -= answers * inner.solve(columns.transpose() * x);
    return x;
  };
  return [once, product](const MatrixXd& b) -> MatrixXd {
    MatrixXd x = once(b);
    x += once(b - product(x));
    return x;
  };
}

}  // namespace clevis::dynamics
