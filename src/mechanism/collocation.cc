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

/// Of the method's matrix.
Eigen::Matrix3d inverse_matrix() {
  Eigen::Matrix3d T, T_inverse, middle;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      T(i, j) = kT[i][j];
      T_inverse(i, j) = kTInverse[i][j];
    }
  }
  middle << kReal, 0.0, 0.0, 0.0, kAlpha, -kBeta, 0.0, kBeta, kAlpha;
  return T * middle * T_inverse;
}
const Eigen::Matrix3d kInverse = inverse_matrix();

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
  T_.setZero(n, n);
  B_.setZero(n, n);
  for (Stages* stages : {&z_, &w_, &f_}) {
    for (VectorXd& v : *stages) v.setZero(n);
  }
  for (VectorXd* v : {&point_, &scratch_, &direction_}) v->setZero(n);
  const Index efforts = system.efforts();
  for (Stages* stages : {&phi_, &kept_, &rho_}) {
    for (VectorXd& v : *stages) v.setZero(efforts);
  }
  phi_now_.setZero(efforts);
  phi_beyond_.setZero(efforts);
  G_.setZero(n, efforts);
  L_.setZero(efforts, n);
  complex_scratch_.setZero(n);
}

void Collocation::start(double t, const VectorXd& y, VectorXd& slope) {
  system_.rate(t, y, slope);
  system_.efforts_by_law(phi_now_);
}

void Collocation::slope(double t, const VectorXd& y, VectorXd& slope) {
  system_.hold_efforts(&phi_now_);
  system_.rate(t, y, slope);
  system_.hold_efforts(nullptr);
}

void Collocation::slope_beyond(double t, const VectorXd& y, const VectorXd& v,
                               VectorXd& slope) {
  point_ = v;
  to_axes(y, point_);
  along_.noalias() = to_tangents_ * point_;
  phi_beyond_ = phi_now_;
  phi_beyond_.noalias() += L_.leftCols(tangents_) * along_;
  point_ = y + v;
  system_.hold_efforts(&phi_beyond_);
  system_.rate(t, point_, slope);
  system_.hold_efforts(nullptr);
}

void Collocation::linearise(double t, const VectorXd& y, const VectorXd& slope,
                            Axes axes) {
  axes_ = axes;
  const double root = std::sqrt(std::numeric_limits<double>::epsilon());
  tangents_ = system_.tangents(t, y, T_);
  system_.hold_tangents(t, y);
  const auto T = T_.leftCols(tangents_);
  system_.efforts_by_law(phi_beyond_);
  // what efforts do is added exactly: differences by them would drown the rest
  system_.hold_efforts(&phi_now_);
  for (Index j = 0; j < tangents_; ++j) {
    point_ = y + root * T_.col(j);
    system_.rate(t, point_, f_[0]);
    B_.col(j) = (f_[0] - slope) / root;
    system_.efforts_by_law(rho_[0]);
    L_.col(j) = (rho_[0] - phi_beyond_) / root;
  }
  evaluations_ += tangents_;
  for (Index k = 0; k < G_.cols(); ++k) {
    system_.effort_response(k, G_.col(k));
  }
  B_.leftCols(tangents_).noalias() += G_ * L_.leftCols(tangents_);
  system_.hold_efforts(nullptr);
  system_.release_tangents();
  for (Index k = 0; k < G_.cols(); ++k) to_axes(y, G_.col(k));
  for (Index j = 0; j < tangents_; ++j) {
    to_axes(y, T_.col(j));
    to_axes(y, B_.col(j));
  }
  gram_.noalias() = T.transpose() * T;
  gram_factor_.compute(gram_);
  to_tangents_ = gram_factor_.solve(T.transpose());
  reduced_.noalias() = to_tangents_ * B_.leftCols(tangents_);
  h_ = 0.0;
}

void Collocation::to_axes(const VectorXd& y, Eigen::Ref<VectorXd> v) const {
  if (axes_ == Axes::kMoving) system_.to_axes(y, v);
}

void Collocation::from_axes(const VectorXd& y, Eigen::Ref<VectorXd> v) const {
  if (axes_ == Axes::kMoving) system_.from_axes(y, v);
}

bool Collocation::factor(double h) {
  const std::complex<double> pair(kAlpha / h, kBeta / h);
  real_matrix_ = -reduced_;
  real_matrix_.diagonal().array() += kReal / h;
  complex_matrix_ = -reduced_;
  complex_matrix_.diagonal().array() += pair;
  if (!real_matrix_.allFinite()) return false;
  real_.compute(real_matrix_);
  complex_.compute(complex_matrix_);
  ++factorisations_;
  h_ = h;
  return true;
}

/// Takes the rates in f_, leaves the changes there.
void Collocation::newton_step(const VectorXd& y, double h) {
  const std::complex<double> pair(kAlpha / h, kBeta / h);
  const auto B = B_.leftCols(tangents_);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) f_[i] -= (kInverse(i, j) / h) * z_[j];
    point_ = y + z_[i];
    to_axes(point_, f_[i]);
    f_[i].noalias() += G_ * rho_[i];
  }
  transform(kTInverse, f_, w_);
  filter_in_axes(w_[0]);
  complex_scratch_.real() = w_[1];
  complex_scratch_.imag() = w_[2];
  complex_along_.noalias() = to_tangents_ * complex_scratch_;
  complex_along_ = complex_.solve(complex_along_);
  complex_scratch_.noalias() += B * complex_along_;
  complex_scratch_ /= pair;
  w_[1] = complex_scratch_.real();
  w_[2] = complex_scratch_.imag();
  transform(kT, w_, f_);
  for (std::size_t i = 0; i < 3; ++i) {
    along_.noalias() = to_tangents_ * f_[i];
    phi_[i] += rho_[i];
    phi_[i].noalias() += L_.leftCols(tangents_) * along_;
    point_ = y + z_[i];
    from_axes(point_, f_[i]);
    z_[i] += f_[i];
  }
}

void Collocation::guess_efforts() {
  for (VectorXd& phi : phi_) phi = phi_now_;
}

void Collocation::guess_efforts(const std::array<double, 3>& s) {
  const double c[3] = {kC1, kC2, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    phi_[i].setZero();
    for (std::size_t j = 0; j < 3; ++j) {
      double weight = 1.0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (k != j) weight *= (s[i] - c[k]) / (c[j] - c[k]);
      }
      phi_[i] += weight * kept_[j];
    }
  }
}

bool Collocation::solve(double t, const VectorXd& y, double h,
                        const VectorXd& weights) {
  const double c[3] = {kC1, kC2, 1.0};
  double last = 0.0;
  contraction_ = 0.0;
  for (iterations_ = 1; iterations_ <= kMostIterations; ++iterations_) {
    for (std::size_t i = 0; i < 3; ++i) {
      point_ = y + z_[i];
      system_.hold_efforts(&phi_[i]);
      system_.rate(t + c[i] * h, point_, f_[i]);
      system_.efforts_by_law(rho_[i]);
      rho_[i] -= phi_[i];
    }
    system_.hold_efforts(nullptr);
    evaluations_ += 3;
    newton_step(y, h);
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

void Collocation::filter(const VectorXd& y, VectorXd& v) {
  to_axes(y, v);
  filter_in_axes(v);
  from_axes(y, v);
}

void Collocation::filter_in_axes(VectorXd& v) {
  along_.noalias() = to_tangents_ * v;
  along_ = real_.solve(along_);
  v.noalias() += B_.leftCols(tangents_) * along_;
  v *= h_ / kReal;
}

void Collocation::embedded(double h, VectorXd& sum) const {
  static const double kE1 = -(13.0 + 7.0 * std::sqrt(6.0)) / 3.0;
  static const double kE2 = (-13.0 + 7.0 * std::sqrt(6.0)) / 3.0;
  constexpr double kE3 = -1.0 / 3.0;
  sum = (kE1 / h) * z_[0] + (kE2 / h) * z_[1] + (kE3 / h) * z_[2];
}

void Collocation::apply_jacobian(const VectorXd& v, VectorXd& result) {
  along_.noalias() = to_tangents_ * v;
  result.noalias() = B_.leftCols(tangents_) * along_;
}

double Collocation::largest_eigenvalue() {
  // the mean growth over some powers: a pair of eigenvalues turns the vector
  constexpr int kBefore = 6, kPowers = 8;
  direction_.setOnes();
  double growth = 0.0;
  for (int i = 0; i < kBefore + kPowers; ++i) {
    direction_ /= direction_.norm();
    apply_jacobian(direction_, scratch_);
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
    apply_jacobian(direction_, scratch_);
    growth = scratch_.norm();
    if (!(growth > 0.0)) return 0.0;
    direction_ = scratch_;
  }
  return growth;
}

}  // namespace clevis::mechanism
