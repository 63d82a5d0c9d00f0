#include "dynamics/systems/updated_factor.h"

#include <utility>

#include <Eigen/Cholesky>

namespace clevis::dynamics {
namespace {

/// Norm over that before an update: what is left of a column that the update
/// takes most of has lost as many digits.
constexpr double kLittle = 1e-3;

}  // namespace

using Eigen::MatrixXd;

BlockOperator updated_factor(const BlockOperator& solve,
                             const MatrixXd& columns, double weight,
                             const BlockOperator& product) {
  const MatrixXd answers = solve(columns);
  MatrixXd between = columns.transpose() * answers;
  between.diagonal().array() += 1.0 / weight;
  const Eigen::LLT<MatrixXd> inner(between);
  const auto once = [solve, answers, inner, columns](const MatrixXd& b) {
    struct {
      MatrixXd x;
      bool is_sharp;
    } found{solve(b), true};
    const Eigen::VectorXd before = found.x.colwise().norm();
    found.x -= answers * inner.solve(columns.transpose() * found.x);
    found.is_sharp = (found.x.colwise().norm().transpose().array() >=
                      kLittle * before.array())
                         .all();
    return found;
  };
  return [once, product](const MatrixXd& b) -> MatrixXd {
    auto [x, is_sharp] = once(b);
    if (!is_sharp) x += once(b - product(x)).x;
    return std::move(x);
  };
}

}  // namespace clevis::dynamics
