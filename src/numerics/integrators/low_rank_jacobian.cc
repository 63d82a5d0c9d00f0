#include "numerics/integrators/low_rank_jacobian.h"

#include <cmath>

namespace clevis::numerics {

using Eigen::Index;
using Eigen::VectorXd;

LowRankJacobian::LowRankJacobian(Index size) {
  T_.setZero(size, size);
  B_.setZero(size, size);
  scratch_.setZero(size);
  direction_.setZero(size);
  complex_scratch_.setZero(size);
}

void LowRankJacobian::take(Index tangents) {
  tangents_ = tangents;
  const auto T = T_.leftCols(tangents);
  gram_.noalias() = T.transpose() * T;
  gram_factor_.compute(gram_);
  to_tangents_ = gram_factor_.solve(T.transpose());
  reduced_.noalias() = to_tangents_ * B_.leftCols(tangents);
  drop_factors();
}

bool LowRankJacobian::factor(const RadauMethod& method, double h) {
  if (!reduced_.allFinite() || !(h > 0.0)) return false;
  matrix_ = -reduced_;
  matrix_.diagonal().array() += method.real / h;
  real_.compute(matrix_);
  for (std::size_t k = 0; k < method.count() / 2; ++k) {
    complex_matrix_ = -reduced_;
    complex_matrix_.diagonal().array() += method.pairs[k] / h;
    complex_[k].compute(complex_matrix_);
  }
  ++factorisations_;
  method_ = &method;
  h_ = h;
  return true;
}

void LowRankJacobian::filter(VectorXd& v) {
  along_.noalias() = to_tangents_ * v;
  along_ = real_.solve(along_);
  v.noalias() += B_.leftCols(tangents_) * along_;
  v *= h_ / method_->real;
}

void LowRankJacobian::filter_pair(std::size_t pair, VectorXd& u, VectorXd& v) {
  complex_scratch_.real() = u;
  complex_scratch_.imag() = v;
  complex_along_.noalias() = to_tangents_ * complex_scratch_;
  complex_along_ = complex_[pair].solve(complex_along_);
  complex_scratch_.noalias() += B_.leftCols(tangents_) * complex_along_;
  complex_scratch_ *= h_ / method_->pairs[pair];
  u = complex_scratch_.real();
  v = complex_scratch_.imag();
}

void LowRankJacobian::apply(const VectorXd& v, VectorXd& result) {
  along_.noalias() = to_tangents_ * v;
  result.noalias() = B_.leftCols(tangents_) * along_;
}

double LowRankJacobian::largest_eigenvalue() {
  // the mean growth over some powers: a pair of eigenvalues turns the vector
  constexpr int kBefore = 6, kPowers = 8;
  direction_.setOnes();
  double growth = 0.0;
  for (int i = 0; i < kBefore + kPowers; ++i) {
    direction_ /= direction_.norm();
    apply(direction_, scratch_);
    const double size = scratch_.norm();
    if (!(size > 0.0)) return 0.0;
    if (i >= kBefore) growth += std::log(size);
    direction_ = scratch_;
  }
  return std::exp(growth / kPowers);
}

double LowRankJacobian::stiffness() {
  constexpr int kPowers = 6;
  if (direction_.squaredNorm() == 0.0) direction_.setOnes();
  double growth = 0.0;
  for (int i = 0; i < kPowers; ++i) {
    direction_ /= direction_.norm();
    apply(direction_, scratch_);
    growth = scratch_.norm();
    if (!(growth > 0.0)) return 0.0;
    direction_ = scratch_;
  }
  return growth;
}

}  // namespace clevis::numerics
