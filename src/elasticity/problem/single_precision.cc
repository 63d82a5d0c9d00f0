#include "elasticity/problem/single_precision.h"

namespace clevis::elasticity {
namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;

ArrayXd products(const MatrixXd& a, const MatrixXd& b) {
  return a.cwiseProduct(b).colwise().sum().transpose().array();
}

MatrixXd scaled(const MatrixXd& columns, const ArrayXd& factors) {
  return columns * factors.matrix().asDiagonal();
}

/// a / b, zero where b is.
ArrayXd quotients(const ArrayXd& a, const ArrayXd& b) {
  return (b > 0.0).select(a / b, 0.0);
}

}  // namespace

std::optional<MatrixXd> solve_by_single_precision(
    const StiffnessAction::Product& multiply, const Inverse& inverse,
    const MatrixXd& right_hand_sides) {
  // A step takes off some four digits; its change is the error before it.
  constexpr int kMostSteps = 40;
  constexpr double kChange = 1e-10;
  constexpr double kRest = 1e-11;  // of the right hand side
  // Of norm 1: squares of what is small stay in the range of floats.
  const ArrayXd norms = right_hand_sides.colwise().norm().transpose().array();
  MatrixXd rest =
      scaled(right_hand_sides, quotients(ArrayXd::Ones(norms.size()), norms));
  MatrixXd x = MatrixXd::Zero(rest.rows(), rest.cols());
  MatrixXd z = inverse(rest);
  MatrixXd direction = z;
  ArrayXd rz = products(rest, z);
  for (int step = 0; step < kMostSteps; ++step) {
    const MatrixXd forces = multiply(direction);
    const ArrayXd length = quotients(rz, products(direction, forces));
    const MatrixXd change = scaled(direction, length);
    x += change;
    rest -= scaled(forces, length);
    const ArrayXd size = x.colwise().norm().transpose().array();
    const ArrayXd changed = change.colwise().norm().transpose().array();
    const ArrayXd left = rest.colwise().norm().transpose().array();
    if ((changed <= kChange * size && left <= kRest).all()) {
      return scaled(x, norms);
    }
    z = inverse(rest);
    // Polak and Ribière's, which bears the rounding of the preconditioner.
    const ArrayXd turn = quotients(-length * products(z, forces), rz).max(0.0);
    rz = products(rest, z);
    direction = z + scaled(direction, turn);
  }
  return std::nullopt;
}

}  // namespace clevis::elasticity
