#include "mechanism/mass_matrix/body_inertias.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "base/values/index.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// F with F Fᵀ = inertia⁻¹.
Matrix3d inverse_root(const Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(inertia);
  return eigen.eigenvectors() *
         eigen.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

BodyInertias::BodyInertias(const MechanismDefinition& definition,
                           const SolvingFrame& frame)
    : planar_(frame.planar),
      length_(frame.length),
      bodies_(definition.bodies.size() + 1) {
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    const part::MassProperties& given =
        definition.bodies[i - 1].mass_properties;
    const Matrix3d& R = frame.placement[i].R;
    Body& body = bodies_[i];
    body.mass = given.mass;
    body.inertia = given.inertia_LCm;
    body.turn_factor = length_ * inverse_root(given.inertia_LCm);
    body.turn_root = body.turn_factor.inverse();
    body.inertia_z = (R * given.inertia_LCm * R.transpose())(2, 2);
  }
}

double BodyInertias::kinetic_energy(const Configuration& x,
                                    const std::vector<Twist>& twists) const {
  double energy = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const Vector3d w_L = x[i].R.transpose() * twists[i].w;
    energy += 0.5 * bodies_[i].mass * twists[i].v.squaredNorm() +
              0.5 * w_L.dot(bodies_[i].inertia * w_L);
  }
  return energy;
}

double BodyInertias::free_response(int slot, const Matrix3d& R,
                                   const SpatialForce& lever) const {
  if (slot == 0) return 0.0;
  const Body& body = bodies_[index(slot)];
  const Vector3d turn = body.turn_factor.transpose() * R.transpose() * lever.w;
  return lever.v.squaredNorm() / body.mass +
         turn.squaredNorm() / (length_ * length_);
}

void BodyInertias::put_constant_blocks(ConstrainedMass& mass) const {
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    const double root = 1.0 / std::sqrt(bodies_[i].mass);
    const int k = static_cast<int>(i) - 1;
    if (planar_) {
      const double turn_root = length_ / std::sqrt(bodies_[i].inertia_z);
      mass.set_diagonal(k, {root, root, turn_root});
    } else {
      mass.set_diagonal(2 * k, Vector3d::Constant(root));
    }
  }
}

void BodyInertias::put_turned_blocks(const Configuration& x,
                                     ConstrainedMass& mass) const {
  for (std::size_t i = 1; i < bodies_.size() && !planar_; ++i) {
    mass.set_full(static_cast<int>(2 * i - 1), x[i].R * bodies_[i].turn_factor,
                  bodies_[i].turn_root * x[i].R.transpose());
  }
}

}  // namespace clevis::mechanism
