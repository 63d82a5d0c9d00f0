#include "dynamics/struck_body/damped_body.h"

#include <map>
#include <utility>
#include <vector>

#include "dynamics/struck_body/damped_scheme.h"

namespace clevis::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Motion {
  VectorXd u, v;
};

class DampedBody : public StruckBody {
 public:
  DampedBody(const LinearSystem& system, const VectorXd& contact)
      : system_(system), c_(contact) {
    rest();
  }

  void set_step(double step) override {
    step_ = step;
    auto found = factors_.find(step);
    if (found == factors_.end()) {
      const double stage = DampedScheme::kPole * step;
      found = factors_.emplace(step, Factor{}).first;
      found->second.solve = system_.factor(1.0 / (stage * stage));
      factor_ = &found->second;
      found->second.answer = unit_answer();
    }
    factor_ = &found->second;
  }

  double compliance() const override { return c_.dot(factor_->answer.u); }

  double free_contact() override {
    free_ = {VectorXd::Zero(system_.size), VectorXd::Zero(system_.size)};
    Motion stage = now_;
    for (const double weight : DampedScheme::weights()) {
      stage = divide(stage);
      free_.u += weight * stage.u;
      free_.v += weight * stage.v;
    }
    return c_.dot(free_.u);
  }

  void advance(double force) override {
    now_.u = free_.u + force * factor_->answer.u;
    now_.v = free_.v + force * factor_->answer.v;
  }

  double contact() const override { return c_.dot(now_.u); }
  double strain_energy() const override {
    return 0.5 * now_.u.dot(system_.stiffness(now_.u).col(0));
  }
  double energy() const override {
    return strain_energy() + 0.5 * now_.v.dot(system_.mass(now_.v).col(0));
  }
  VectorXd state() const override { return now_.u; }
  void rest() override {
    now_ = {VectorXd::Zero(system_.size), VectorXd::Zero(system_.size)};
  }

 private:
  struct Factor {
    BlockOperator solve;  ///< with K + M/(γ h)²
    Motion answer;        ///< at the end of a step with a unit force, from rest
  };

  double stage() const { return DampedScheme::kPole * step_; }

  /// (1 − γ h A)^-1 (u, v): w − γ h w' = u, w' + γ h M⁻¹K w = v.
  Motion divide(const Motion& from) const {
    const double g = stage();
    Motion result;
    result.u = factor_->solve(system_.mass((from.u + g * from.v) / (g * g)));
    result.v = (result.u - from.u) / g;
    return result;
  }

  /// h φ(h A) (0, M⁻¹c), φ(x) = (R(x) − 1)/x = γ Σ a_j Σ_{i ≤ j} (1 − γ x)^-i.
  Motion unit_answer() const {
    const double g = stage();
    Motion power;
    power.u = factor_->solve(c_ / g);
    power.v = power.u / g;
    Motion sum{VectorXd::Zero(system_.size), VectorXd::Zero(system_.size)};
    double rest = 0.0;  // Σ a_j over j >= i
    for (const double weight : DampedScheme::weights()) rest += weight;
    for (const double weight : DampedScheme::weights()) {
      sum.u += g * rest * power.u;
      sum.v += g * rest * power.v;
      rest -= weight;
      power = divide(power);
    }
    return sum;
  }

  const LinearSystem& system_;
  const VectorXd& c_;
  double step_{};
  std::map<double, Factor> factors_;
  const Factor* factor_{};
  Motion now_, free_;
};

}  // namespace

std::unique_ptr<StruckBody> damped_body(const LinearSystem& system,
                                        const VectorXd& contact) {
  return std::make_unique<DampedBody>(system, contact);
}

}  // namespace clevis::dynamics
