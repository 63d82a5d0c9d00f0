#include "numerics/integrators/collocation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace clevis::numerics {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double kConverged = 0.003;

/// to = table from, for the first `count` ones.
void transform(const RadauMethod::Table& table, std::size_t count,
               const Collocation::Stages& from, Collocation::Stages& to) {
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = table[i][0] * from[0];
    for (std::size_t j = 1; j < count; ++j) to[i] += table[i][j] * from[j];
  }
}

}  // namespace

double weighted_norm(const VectorXd& error, const VectorXd& weights) {
  const auto n = static_cast<double>(error.size());
  return std::sqrt(error.cwiseProduct(weights).squaredNorm() / n);
}

Collocation::Collocation(OdeSystem& system)
    : system_(system), jacobian_(system.size()) {
  const Index n = system.size();
  for (Stages* stages : {&z_, &w_, &f_}) {
    for (VectorXd& v : *stages) v.setZero(n);
  }
  point_.setZero(n);
  const Index efforts = system.efforts();
  for (Stages* stages : {&phi_, &kept_, &rho_}) {
    for (VectorXd& v : *stages) v.setZero(efforts);
  }
  phi_now_.setZero(efforts);
  phi_beyond_.setZero(efforts);
  G_.setZero(n, efforts);
  L_.setZero(efforts, n);
}

void Collocation::use(const RadauMethod& method) {
  if (method_ != &method) jacobian_.drop_factors();
  method_ = &method;
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
  jacobian_.along_tangents(point_, along_);
  phi_beyond_ = phi_now_;
  phi_beyond_.noalias() += L_.leftCols(along_.size()) * along_;
  point_ = y + v;
  system_.hold_efforts(&phi_beyond_);
  system_.rate(t, point_, slope);
  system_.hold_efforts(nullptr);
}

void Collocation::linearise(double t, const VectorXd& y, const VectorXd& slope,
                            Axes axes) {
  axes_ = axes;
  const double root = std::sqrt(std::numeric_limits<double>::epsilon());
  Eigen::MatrixXd& T = jacobian_.tangents();
  Eigen::MatrixXd& B = jacobian_.images();
  const Index tangents = system_.tangents(t, y, T);
  system_.hold_tangents(t, y);
  system_.efforts_by_law(phi_beyond_);
  // what efforts do is added exactly: differences by them would drown the rest
  system_.hold_efforts(&phi_now_);
  for (Index j = 0; j < tangents; ++j) {
    point_ = y + root * T.col(j);
    system_.rate(t, point_, f_[0]);
    B.col(j) = (f_[0] - slope) / root;
    system_.efforts_by_law(rho_[0]);
    L_.col(j) = (rho_[0] - phi_beyond_) / root;
  }
  evaluations_ += tangents;
  for (Index k = 0; k < G_.cols(); ++k) {
    system_.effort_response(k, G_.col(k));
  }
  B.leftCols(tangents).noalias() += G_ * L_.leftCols(tangents);
  system_.hold_efforts(nullptr);
  system_.release_tangents();
  for (Index k = 0; k < G_.cols(); ++k) to_axes(y, G_.col(k));
  for (Index j = 0; j < tangents; ++j) {
    to_axes(y, T.col(j));
    to_axes(y, B.col(j));
  }
  jacobian_.take(tangents);
}

void Collocation::to_axes(const VectorXd& y, Eigen::Ref<VectorXd> v) const {
  if (axes_ == Axes::kMoving) system_.to_axes(y, v);
}

void Collocation::from_axes(const VectorXd& y, Eigen::Ref<VectorXd> v) const {
  if (axes_ == Axes::kMoving) system_.from_axes(y, v);
}

/// Takes the rates in f_, leaves the changes there.
void Collocation::newton_step(const VectorXd& y, double h) {
  for (std::size_t i = 0; i < count(); ++i) {
    for (std::size_t j = 0; j < count(); ++j) {
      f_[i] -= (method_->inverse[i][j] / h) * z_[j];
    }
    point_ = y + z_[i];
    to_axes(point_, f_[i]);
    f_[i].noalias() += G_ * rho_[i];
  }
  transform(method_->T_inverse, count(), f_, w_);
  jacobian_.filter(w_[0]);
  for (std::size_t k = 0; 2 * k + 2 < count(); ++k) {
    jacobian_.filter_pair(k, w_[1 + 2 * k], w_[2 + 2 * k]);
  }
  transform(method_->T, count(), w_, f_);
  for (std::size_t i = 0; i < count(); ++i) {
    jacobian_.along_tangents(f_[i], along_);
    phi_[i] += rho_[i];
    phi_[i].noalias() += L_.leftCols(along_.size()) * along_;
    point_ = y + z_[i];
    from_axes(point_, f_[i]);
    z_[i] += f_[i];
  }
}

void Collocation::accept() {
  std::swap(kept_, phi_);
  kept_method_ = method_;
  phi_now_ = kept_[count() - 1];
}

void Collocation::guess_efforts() {
  for (VectorXd& phi : phi_) phi = phi_now_;
}

void Collocation::guess_efforts(const RadauMethod::Weights& s) {
  for (std::size_t i = 0; i < count(); ++i) {
    const RadauMethod::Weights weights = kept_method_->through_stages(s[i]);
    phi_[i].setZero();
    for (std::size_t j = 0; j < kept_method_->count(); ++j) {
      phi_[i] += weights[j] * kept_[j];
    }
  }
}

bool Collocation::solve(double t, const VectorXd& y, double h,
                        const VectorXd& weights) {
  double last = 0.0;
  contraction_ = 0.0;
  for (iterations_ = 1; iterations_ <= most_iterations(); ++iterations_) {
    for (std::size_t i = 0; i < count(); ++i) {
      point_ = y + z_[i];
      system_.hold_efforts(&phi_[i]);
      system_.rate(t + method_->c[i] * h, point_, f_[i]);
      system_.efforts_by_law(rho_[i]);
      rho_[i] -= phi_[i];
    }
    system_.hold_efforts(nullptr);
    evaluations_ += method_->stages;
    newton_step(y, h);
    double size = 0.0;
    for (std::size_t i = 0; i < count(); ++i) {
      size += std::pow(weighted_norm(f_[i], weights), 2);
    }
    size = std::sqrt(size / method_->stages);
    if (!std::isfinite(size)) return false;
    if (iterations_ > 1) {
      const double ratio = size / last;
      contraction_ = iterations_ == 2 ? ratio : std::sqrt(ratio * contraction_);
      if (contraction_ >= 0.99) return false;
      const double left = most_iterations() - iterations_;
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
  jacobian_.filter(v);
  from_axes(y, v);
}

void Collocation::embedded(double h, VectorXd& sum) const {
  sum = (method_->error[0] / h) * z_[0];
  for (std::size_t i = 1; i < count(); ++i) {
    sum += (method_->error[i] / h) * z_[i];
  }
}

}  // namespace clevis::numerics
