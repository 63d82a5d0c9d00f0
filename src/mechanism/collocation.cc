#include "mechanism/collocation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Of the inverse of the method's matrix: the real eigenvalue, the pair.
const double kReal = 30.0 / (6.0 + std::cbrt(81.0) - std::cbrt(9.0));
const double kAlpha0 = (12.0 - std::cbrt(81.0) + std::cbrt(9.0)) / 60.0;
const double kBeta0 =
    (std::cbrt(81.0) + std::cbrt(9.0)) * std::sqrt(3.0) / 60.0;
const double kNorm = kAlpha0 * kAlpha0 + kBeta0 * kBeta0;
const double kAlpha = kAlpha0 / kNorm, kBeta = kBeta0 / kNorm;

constexpr double kT[3][3] = {
    {9.1232394870892942792e-02, -0.14125529502095420843,
     -3.0029194105147424492e-02},
    {0.24171793270710701896, 0.20412935229379993199, 0.38294211275726193779},
    {0.96604818261509293619, 1.0, 0.0}};
constexpr double kTInverse[3][3] = {
    {4.3255798900631553510, 0.33919925181580986954, 0.54177053993587487119},
    {-4.1787185915519047273, -0.32768282076106238708, 0.47662355450055045196},
    {-0.50287263494578687595, 2.5719269498556054292, -0.59603920482822492497}};

constexpr double kConverged = 0.003;

void transform(const double (&matrix)[3][3], const Collocation::Stages& from,
               Collocation::Stages& to) {
  for (std::size_t i = 0; i < 3; ++i) {
    to[i] = matrix[i][0] * from[0] + matrix[i][1] * from[1] +
            matrix[i][2] * from[2];
  }
}

}  // namespace

const double Collocation::kC1 = (4.0 - std::sqrt(6.0)) / 10.0;
const double Collocation::kC2 = (4.0 + std::sqrt(6.0)) / 10.0;

double weighted_norm(const VectorXd& error, const VectorXd& weights) {
  const auto n = static_cast<double>(error.size());
  return std::sqrt(error.cwiseProduct(weights).squaredNorm() / n);
}

Collocation::Collocation(OdeSystem& system) : system_(system) {
  const Index n = system.size();
  J_.setZero(n, n);
  real_matrix_.setZero(n, n);
  complex_matrix_.setZero(n, n);
  real_ = Eigen::PartialPivLU<Eigen::MatrixXd>(n);
  complex_ = Eigen::PartialPivLU<Eigen::MatrixXcd>(n);
  for (Stages* stages : {&z_, &w_, &f_}) {
    for (VectorXd& v : *stages) v.setZero(n);
  }
  for (VectorXd* v : {&point_, &scratch_, &direction_}) v->setZero(n);
  complex_scratch_.setZero(n);
  complex_solution_.setZero(n);
}

void Collocation::linearise(double t, const VectorXd& y,
                            const VectorXd& slope) {
  const double root = std::sqrt(std::numeric_limits<double>::epsilon());
  system_.scales(y, scratch_);
  system_.hold_tangents(t, y);
  point_ = y;
  for (Index j = 0; j < y.size(); ++j) {
    if (scratch_[j] == 0.0) {  // nothing depends on it
      J_.col(j).setZero();
      continue;
    }
    const double step = root * std::max(std::abs(y[j]), scratch_[j]);
    point_[j] = y[j] + step;
    system_.rate(t, point_, f_[0]);
    ++evaluations_;
    J_.col(j) = (f_[0] - slope) / (point_[j] - y[j]);
    point_[j] = y[j];
  }
  system_.release_tangents();
  h_ = 0.0;
}

bool Collocation::factor(double h) {
  const std::complex<double> pair(kAlpha / h, kBeta / h);
  real_matrix_ = -J_;
  real_matrix_.diagonal().array() += kReal / h;
  complex_matrix_.real() = -J_;
  complex_matrix_.imag().setZero();
  complex_matrix_.diagonal().array() += pair;
  if (!real_matrix_.allFinite()) return false;
  real_.compute(real_matrix_);
  complex_.compute(complex_matrix_);
  ++factorisations_;
  h_ = h;
  return true;
}

void Collocation::newton_step(double h) {
  const std::complex<double> pair(kAlpha / h, kBeta / h);
  // z_ is free here: T⁻¹ f
  transform(kTInverse, f_, z_);
  scratch_ = z_[0] - (kReal / h) * w_[0];
  point_ = real_.solve(scratch_);
  f_[0] = point_;
  complex_scratch_.real() = z_[1];
  complex_scratch_.imag() = z_[2];
  for (Index j = 0; j < complex_scratch_.size(); ++j) {
    complex_scratch_[j] -= pair * std::complex<double>(w_[1][j], w_[2][j]);
  }
  complex_solution_ = complex_.solve(complex_scratch_);
  f_[1] = complex_solution_.real();
  f_[2] = complex_solution_.imag();
  for (std::size_t i = 0; i < 3; ++i) w_[i] += f_[i];
  transform(kT, w_, z_);
}

bool Collocation::solve(double t, const VectorXd& y, double h,
                        const VectorXd& weights) {
  transform(kTInverse, z_, w_);
  const double c[3] = {kC1, kC2, 1.0};
  double last = 0.0;
  contraction_ = 0.0;
  for (iterations_ = 1; iterations_ <= kMostIterations; ++iterations_) {
    for (std::size_t i = 0; i < 3; ++i) {
      point_ = y + z_[i];
      system_.rate(t + c[i] * h, point_, f_[i]);
    }
    evaluations_ += 3;
    newton_step(h);
    double size = 0.0;
    for (const VectorXd& change : f_) {
      size += std::pow(weighted_norm(change, weights), 2);
    }
    size = std::sqrt(size / 3.0);
    if (!std::isfinite(size)) return false;
    if (iterations_ > 1) {
      const double ratio = size / last;
      contraction_ = iterations_ == 2 ? ratio : std::sqrt(ratio * contraction_);
      if (contraction_ >= 0.99) return false;
      const double left = kMostIterations - iterations_;
      const double reachable =
          size * std::pow(contraction_, left) / (1.0 - contraction_);
      if (reachable > kConverged * 10.0) return false;
      if (size * contraction_ / (1.0 - contraction_) <= kConverged) return true;
    } else if (size <= 1e-3 * kConverged) {
      return true;
    }
    last = size;
  }
  return false;
}

void Collocation::filter(VectorXd& v) {
  scratch_ = v;
  v = real_.solve(scratch_);
}

void Collocation::embedded(double h, VectorXd& sum) const {
  static const double kE1 = -(13.0 + 7.0 * std::sqrt(6.0)) / 3.0;
  static const double kE2 = (-13.0 + 7.0 * std::sqrt(6.0)) / 3.0;
  constexpr double kE3 = -1.0 / 3.0;
  sum = (kE1 / h) * z_[0] + (kE2 / h) * z_[1] + (kE3 / h) * z_[2];
}

double Collocation::largest_eigenvalue() {
  // the mean growth over some powers: a pair of eigenvalues turns the vector
  constexpr int kBefore = 6, kPowers = 8;
  direction_.setOnes();
  double growth = 0.0;
  for (int i = 0; i < kBefore + kPowers; ++i) {
    direction_ /= direction_.norm();
    scratch_.noalias() = J_ * direction_;
    const double size = scratch_.norm();
    if (!(size > 0.0)) return 0.0;
    if (i >= kBefore) growth += std::log(size);
    direction_ = scratch_;
  }
  return std::exp(growth / kPowers);
}

double Collocation::stiffness() {
  constexpr int kPowers = 6;
  if (direction_.squaredNorm() == 0.0) direction_.setOnes();
  double growth = 0.0;
  for (int i = 0; i < kPowers; ++i) {
    direction_ /= direction_.norm();
    scratch_.noalias() = J_ * direction_;
    growth = scratch_.norm();
    if (!(growth > 0.0)) return 0.0;
    direction_ = scratch_;
  }
  return growth;
}

}  // namespace clevis::mechanism
