#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

#include "benchmarks/reference_trajectories.h"
#include "support/bricard_equations.h"
#include "support/governor_equations.h"
#include "support/planar_linkage.h"

/// Equations of the mechanisms for SUNDIALS, which integrates and knows no
/// mechanism.
namespace clevis::benchmarks {

/// y' = f(y), perhaps on constraints.
class Equations {
 public:
  virtual ~Equations() = default;
  virtual Eigen::VectorXd start() const = 0;
  virtual Eigen::VectorXd rates(const Eigen::VectorXd& y) const = 0;
  virtual Sample sample(const Eigen::VectorXd& y) const = 0;
  /// y back onto the constraints.
  virtual bool constrained() const { return false; }
  virtual Eigen::VectorXd projected(const Eigen::VectorXd& y) const {
    return y;
  }
};

/// A planar linkage in its bodies' own coordinates (centre, angle) and their
/// rates, all joints as constraints.
class LinkageEquations : public Equations {
 public:
  using Linkage = mechanism::testing::PlanarLinkage;
  using Vector = Eigen::VectorXd;

  explicit LinkageEquations(const Linkage& linkage)
      : m_(linkage), n_(3 * Eigen::Index(linkage.bodies.size())) {
    weight_.resize(n_);
    for (Eigen::Index i = 0; i < n_; ++i) {
      const auto& body = m_.bodies[std::size_t(i / 3)];
      weight_[i] = 1.0 / (i % 3 == 2 ? body.inertia : body.mass);
    }
    rows_ = Eigen::Index(2 * m_.joints.size());
  }

  Eigen::Index coordinates() const { return n_; }
  Eigen::Index rows() const { return rows_; }
  /// 1/mass or 1/inertia of each coordinate.
  const Vector& weight() const { return weight_; }

  Vector start() const override {
    Vector y(2 * n_);
    for (std::size_t i = 0; i < m_.bodies.size(); ++i) {
      const auto& body = m_.bodies[i];
      const Eigen::Vector2d centre = body.at(body.centre);
      const Eigen::Vector2d arm = centre - body.origin;
      const Eigen::Vector2d v =
          body.velocity + body.rate * Eigen::Vector2d(-arm.y(), arm.x());
      y.segment<3>(Eigen::Index(3 * i)) << centre, body.angle;
      y.segment<3>(n_ + Eigen::Index(3 * i)) << v, body.rate;
    }
    return y;
  }

  /// Gaps of the joints [m]; of a slide height [m] and angle [rad].
  Vector gaps(const Vector& q) const {
    Vector g(rows_);
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
      const auto& joint = m_.joints[j];
      auto two = g.segment<2>(Eigen::Index(2 * j));
      if (joint.slides) {
        two = q.segment<2>(3 * joint.b + 1);
      } else {
        two = point(q, joint.b, joint.p_b) - point(q, joint.a, joint.p_a);
      }
    }
    return g;
  }

  Eigen::MatrixXd jacobian(const Vector& q) const {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows_, n_);
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
      const auto& joint = m_.joints[j];
      const auto row = Eigen::Index(2 * j);
      if (joint.slides) {
        J(row, 3 * joint.b + 1) = J(row + 1, 3 * joint.b + 2) = 1.0;
        continue;
      }
      const auto fill = [&](int body, const Eigen::Vector2d& p, double sign) {
        if (body < 0) return;
        const Eigen::Vector2d r = arm(q, body, p);
        J(row, 3 * body) = J(row + 1, 3 * body + 1) = sign;
        J(row, 3 * body + 2) = -sign * r.y();
        J(row + 1, 3 * body + 2) = sign * r.x();
      };
      fill(joint.b, joint.p_b, 1.0);
      fill(joint.a, joint.p_a, -1.0);
    }
    return J;
  }

  /// Forces on the coordinates [N], [N m], without the joints'.
  Vector forces(const Vector& q) const {
    Vector Q = Vector::Zero(n_);
    for (std::size_t i = 0; i < m_.bodies.size(); ++i) {
      Q[Eigen::Index(3 * i) + 1] = -m_.bodies[i].mass * m_.gravity;
    }
    for (const auto& spring : m_.springs) {
      const Eigen::Vector2d apart =
          point(q, spring.b, spring.p_b) - point(q, spring.a, spring.p_a);
      const double length = apart.norm();
      const Eigen::Vector2d pull =
          spring.stiffness * (length - spring.free) / length * apart;
      pull_at(q, spring.b, spring.p_b, -pull, Q);
      pull_at(q, spring.a, spring.p_a, pull, Q);
    }
    if (m_.turned >= 0) Q[3 * m_.turned + 2] += m_.torque;
    return Q;
  }

  struct Answer {
    Vector acceleration, force;  ///< of the joints on their second bodies
  };
  Answer solve(const Vector& y) const {
    const Vector q = y.head(n_), v = y.tail(n_);
    const Eigen::MatrixXd J = jacobian(q);
    const Vector free = weight_.cwiseProduct(forces(q));
    const Vector force = divided(J, inward(q, v) - J * free);
    return {free + weight_.cwiseProduct(J.transpose() * force), force};
  }

  Vector rates(const Vector& y) const override {
    Vector rate(2 * n_);
    rate << y.tail(n_), solve(y).acceleration;
    return rate;
  }

  bool constrained() const override { return true; }
  Vector projected(const Vector& y) const override {
    Vector q = y.head(n_), v = y.tail(n_);
    for (int i = 0; i < 3; ++i) {
      const Vector gap = gaps(q);
      if (gap.lpNorm<Eigen::Infinity>() < 1e-14) break;
      q -= lifted(jacobian(q), gap);
    }
    const Eigen::MatrixXd J = jacobian(q);
    v -= lifted(J, J * v);
    Vector back(2 * n_);
    back << q, v;
    return back;
  }

  Sample sample(const Vector& y) const override {
    const Vector q = y.head(n_), v = y.tail(n_);
    Sample sample;
    const double angle = q[3 * m_.pointer + 2];
    sample.point = {std::cos(angle), std::sin(angle), 0.0};
    if (m_.slider >= 0) {
      const auto& body = m_.bodies[std::size_t(m_.slider)];
      sample.point.z() = point(q, m_.slider, body.centre).x();
    }
    sample.gap = gaps(q).lpNorm<Eigen::Infinity>();
    sample.pin = solve(y).force.segment<2>(2 * m_.watched).norm();
    if (m_.turned < 0) sample.energy = energy(q, v);
    return sample;
  }

 private:
  Eigen::Vector2d arm(const Vector& q, int body,
                      const Eigen::Vector2d& p) const {
    const Eigen::Vector2d r = p - m_.bodies[std::size_t(body)].centre;
    const double c = std::cos(q[3 * body + 2]), s = std::sin(q[3 * body + 2]);
    return {c * r.x() - s * r.y(), s * r.x() + c * r.y()};
  }
  Eigen::Vector2d point(const Vector& q, int body,
                        const Eigen::Vector2d& p) const {
    if (body < 0) return p;
    return Eigen::Vector2d(q.segment<2>(3 * body)) + arm(q, body, p);
  }
  void pull_at(const Vector& q, int body, const Eigen::Vector2d& p,
               const Eigen::Vector2d& f, Vector& Q) const {
    if (body < 0) return;
    const Eigen::Vector2d r = arm(q, body, p);
    Q.segment<2>(3 * body) += f;
    Q[3 * body + 2] += r.x() * f.y() - r.y() * f.x();
  }

  /// What J a is: the centripetal accelerations between the joints' bodies.
  Vector inward(const Vector& q, const Vector& v) const {
    Vector gamma = Vector::Zero(rows_);
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
      const auto& joint = m_.joints[j];
      if (joint.slides) continue;
      auto two = gamma.segment<2>(Eigen::Index(2 * j));
      const auto of = [&](int body, const Eigen::Vector2d& p) {
        const double w = v[3 * body + 2];
        return Eigen::Vector2d(w * w * arm(q, body, p));
      };
      two = of(joint.b, joint.p_b);
      if (joint.a >= 0) two -= of(joint.a, joint.p_a);
    }
    return gamma;
  }

  /// (J M⁻¹ Jᵀ)⁻¹ of a vector; of least norm where a change point takes rows.
  Vector divided(const Eigen::MatrixXd& J, const Vector& right) const {
    const Eigen::MatrixXd S = J * weight_.asDiagonal() * J.transpose();
    const Eigen::LDLT<Eigen::MatrixXd> quick(S);
    const auto pivots = quick.vectorD().cwiseAbs();
    if (pivots.minCoeff() > 1e-7 * pivots.maxCoeff()) {
      return quick.solve(right);
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> slow;
    slow.setThreshold(1e-10);
    slow.compute(S);
    return slow.solve(right);
  }
  Vector lifted(const Eigen::MatrixXd& J, const Vector& gap) const {
    return weight_.cwiseProduct(J.transpose() * divided(J, gap));
  }

  double energy(const Vector& q, const Vector& v) const {
    double sum = 0.5 * (v.array().square() / weight_.array()).sum();
    for (std::size_t i = 0; i < m_.bodies.size(); ++i) {
      sum += m_.bodies[i].mass * m_.gravity * q[Eigen::Index(3 * i) + 1];
    }
    for (const auto& spring : m_.springs) {
      const double stretch =
          (point(q, spring.b, spring.p_b) - point(q, spring.a, spring.p_a))
              .norm() -
          spring.free;
      sum += 0.5 * spring.stiffness * stretch * stretch;
    }
    return sum;
  }

  Linkage m_;
  Eigen::Index n_{}, rows_{};
  Vector weight_;
};

/// In the three coordinates of GovernorEquations.
class GovernorOde : public Equations {
 public:
  Eigen::VectorXd start() const override { return wide(equations_.state()); }
  Eigen::VectorXd rates(const Eigen::VectorXd& y) const override {
    return wide(equations_.rate({y[0], y[1], y[2], y[3]}));
  }
  Sample sample(const Eigen::VectorXd& y) const override {
    Sample sample;
    sample.point.z() = -y[0];
    return sample;
  }

 private:
  static Eigen::VectorXd wide(const std::array<double, 4>& y) {
    return Eigen::Map<const Eigen::Vector4d>(y.data());
  }
  mechanism::testing::GovernorEquations equations_{{}};
};

/// On the closed form of BricardEquations.
class BricardOde : public Equations {
 public:
  using Closed = mechanism::testing::BricardEquations;
  Eigen::VectorXd start() const override { return Closed().state(); }
  Eigen::VectorXd rates(const Eigen::VectorXd& y) const override {
    return Closed::rate(y);
  }
  Sample sample(const Eigen::VectorXd& y) const override {
    Sample sample;
    sample.point = Closed::corner(y);
    sample.energy = Closed::energy(y);
    return sample;
  }
};

}  // namespace clevis::benchmarks
