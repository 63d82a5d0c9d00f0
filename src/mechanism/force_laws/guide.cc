#include "mechanism/force_laws/guide.h"

namespace clevis::mechanism {

using Eigen::Matrix2d;
using Eigen::Vector2d;

Matrix2d end_forces(const Guide& guide, double q, const JointLoad& load) {
  const Vector2d force = load.head<2>();
  Matrix2d ends = Matrix2d::Zero();
  if (guide.length == 0.0) {
    ends.col(0) = force;
    return ends;
  }
  Vector2d moment = load.segment<2>(3);
  if (!guide.is_on_b) moment += q * Vector2d(-force.y(), force.x());
  // F₁ + F₂ = F and (L/2) z × (F₁ − F₂) = M
  const Vector2d pair = 2.0 / guide.length * Vector2d(moment.y(), -moment.x());
  ends.col(0) = 0.5 * (force + pair);
  ends.col(1) = 0.5 * (force - pair);
  return ends;
}

double pressing_force(const Matrix2d& end_forces) {
  return end_forces.colwise().norm().sum();
}

}  // namespace clevis::mechanism
