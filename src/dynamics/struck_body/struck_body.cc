#include "dynamics/struck_body/struck_body.h"

#include <cmath>
#include <map>
#include <utility>

#include "dynamics/struck_body/damped_scheme.h"

namespace clevis::dynamics {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class DirectBody : public StruckBody {
 public:
  DirectBody(const LinearSystem& system, const VectorXd& contact)
      : system_(system), c_(contact) {
    rest();
  }

  void set_step(double step) override {
    step_ = step;
    auto found = factors_.find(step);
    if (found == factors_.end()) {
      const BlockOperator solve = system_.factor(4.0 / (step * step));
      found = factors_.emplace(step, Factor{solve, solve(c_)}).first;
    }
    factor_ = &found->second;
  }

  double compliance() const override {
    return 2.0 * c_.dot(factor_->answer.col(0));
  }

  double free_contact() override {
    free_ = factor_->solve(
        system_.mass(4.0 / (step_ * step_) * u_ + 2.0 / step_ * v_));
    return 2.0 * c_.dot(free_) - c_.dot(u_);
  }

  void advance(double force) override {
    const VectorXd next = 2.0 * (free_ + force * factor_->answer.col(0)) - u_;
    v_ = 2.0 / step_ * (next - u_) - v_;
    u_ = next;
  }

  double contact() const override { return c_.dot(u_); }
  double strain_energy() const override {
    return 0.5 * u_.dot(system_.stiffness(u_).col(0));
  }
  double energy() const override {
    return strain_energy() + 0.5 * v_.dot(system_.mass(v_).col(0));
  }
  VectorXd state() const override { return u_; }
  void rest() override {
    u_ = VectorXd::Zero(system_.size);
    v_ = VectorXd::Zero(system_.size);
  }

 private:
  struct Factor {
    BlockOperator solve;
    MatrixXd answer;  ///< to c
  };
  const LinearSystem& system_;
  const VectorXd& c_;
  double step_{};
  std::map<double, Factor> factors_;
  const Factor* factor_{};
  VectorXd u_, v_, free_;
};

/// (1 − cos x)/x² and (sin x)/x, without cancellation.
double half_versine(double x) {
  const double s = std::abs(x) < 1e-8 ? 1.0 : std::sin(0.5 * x) / (0.5 * x);
  return 0.5 * s * s;
}
double sinc(double x) {
  return std::abs(x) < 1e-8 ? 1.0 : std::sin(x) / x;
}

class ModalBody : public StruckBody {
 public:
  ModalBody(const VectorXd& squares, const VectorXd& contact,
            double damping_time, double damping)
      : squares_(squares.array().max(0.0)),
        c_(contact),
        damping_time_(damping_time),
        damping_(damping) {
    rest();
  }

  void set_step(double step) override {
    const ArrayXd phase = squares_.sqrt() * step;
    cosine_ = phase.cos();
    sine_over_ = phase.unaryExpr(&sinc) * step;
    turned_ = squares_ * sine_over_;
    by_force_ = phase.unaryExpr(&half_versine) * step * step * c_;
    by_force_speed_ = sine_over_ * c_;
    turned_cosine_ = cosine_;
    if (damping_ > 0.0) lose(step);
    if (damping_time_ > 0.0) damp(step);
  }

  double compliance() const override { return (c_ * by_force_).sum(); }

  double free_contact() override {
    free_ = cosine_ * q_ + sine_over_ * v_;
    return (c_ * free_).sum();
  }

  void advance(double force) override {
    v_ = turned_cosine_ * v_ - turned_ * q_ + by_force_speed_ * force;
    q_ = free_ + by_force_ * force;
  }

  double contact() const override { return (c_ * q_).sum(); }
  double strain_energy() const override {
    return 0.5 * (squares_ * q_.square()).sum();
  }
  double energy() const override {
    return strain_energy() + 0.5 * v_.square().sum();
  }
  VectorXd state() const override { return q_; }
  void rest() override {
    q_ = ArrayXd::Zero(c_.size());
    v_ = ArrayXd::Zero(c_.size());
  }

 private:
  /// The exact answer with damping, of what is no rigid motion.
  void lose(double step) {
    constexpr double kShort = 1e-3;  // by a series, without cancellation
    const double root = std::sqrt(1.0 - damping_ * damping_);
    for (Index i = 0; i < squares_.size(); ++i) {
      const double omega = std::sqrt(squares_[i]);
      if (!(omega > 0.0)) continue;
      const double x = omega * step, left = std::exp(-damping_ * x);
      const double sine = left * std::sin(root * x) / root;
      const double cosine = left * std::cos(root * x);
      cosine_[i] = cosine + damping_ * sine;
      turned_cosine_[i] = cosine - damping_ * sine;
      sine_over_[i] = sine / omega;
      turned_[i] = sine * omega;
      by_force_[i] =
          c_[i] * (x < kShort
                       ? step * step *
                             (0.5 - damping_ * x / 3.0 +
                              (4.0 * damping_ * damping_ - 1.0) * x * x / 24.0)
                       : (1.0 - cosine_[i]) / squares_[i]);
      by_force_speed_[i] = sine_over_[i] * c_[i];
    }
  }

  /// The scheme's factor for the damped frequency, with what damping leaves.
  void damp(double step) {
    constexpr double kExact = 1e-2;  // R is the exponential to round-off
    const double root = std::sqrt(1.0 - damping_ * damping_);
    for (Index i = 0; i < squares_.size(); ++i) {
      const double omega = std::sqrt(squares_[i]);
      if (omega * damping_time_ < kExact) continue;
      const auto factor =
          DampedScheme::amplification(root * omega * damping_time_,
                                      step / damping_time_) *
          std::exp(-damping_ * omega * step);
      const double sine = factor.imag() / root;
      cosine_[i] = factor.real() + damping_ * sine;
      turned_cosine_[i] = factor.real() - damping_ * sine;
      sine_over_[i] = sine / omega;
      turned_[i] = sine * omega;
      by_force_[i] = (1.0 - cosine_[i]) / squares_[i] * c_[i];
      by_force_speed_[i] = sine_over_[i] * c_[i];
    }
  }

  ArrayXd squares_, c_;
  double damping_time_, damping_;
  ArrayXd cosine_, sine_over_, turned_;  ///< cos ωh, sin ωh/ω, ω sin ωh
  ArrayXd turned_cosine_;                ///< cos ωh of the speed
  ArrayXd by_force_, by_force_speed_;    ///< of a unit force over a step
  ArrayXd q_, v_, free_;
};

}  // namespace

std::unique_ptr<StruckBody> direct_body(const LinearSystem& system,
                                        const VectorXd& contact) {
  return std::make_unique<DirectBody>(system, contact);
}

std::unique_ptr<StruckBody> modal_body(const VectorXd& squares,
                                       const VectorXd& contact,
                                       double damping_time, double damping) {
  return std::make_unique<ModalBody>(squares, contact, damping_time, damping);
}

}  // namespace clevis::dynamics
