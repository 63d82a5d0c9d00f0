#include "mechanism/joint_space/articulated_bodies.h"

#include <cmath>
#include <utility>

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double dot(const Twist& a, const Twist& b) {
  return a.v.dot(b.v) + a.w.dot(b.w);
}

void add(double factor, const Twist& what, Twist& to) {
  to.v += factor * what.v;
  to.w += factor * what.w;
}

/// m [r]×, each row crossed with r.
Matrix3d times_cross(const Matrix3d& m, const Vector3d& r) {
  Matrix3d result;
  for (int i = 0; i < 3; ++i) {
    result(i, 0) = m(i, 1) * r.z() - m(i, 2) * r.y();
    result(i, 1) = m(i, 2) * r.x() - m(i, 0) * r.z();
    result(i, 2) = m(i, 0) * r.y() - m(i, 1) * r.x();
  }
  return result;
}

}  // namespace

ArticulatedBodies::ArticulatedBodies(const MechanismDefinition& definition,
                                     const JointCoordinates& coordinates,
                                     std::vector<double> armatures)
    : coordinates_(coordinates),
      armatures_(std::move(armatures)),
      bodies_(coordinates.links().size()) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const part::MassProperties& given =
        definition.bodies[coordinates.links()[k].slot - 1].mass_properties;
    bodies_[k].mass = given.mass;
    bodies_[k].own = given.inertia_LCm;
  }
}

void ArticulatedBodies::place_inertias(const Configuration& x) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Body& body = bodies_[k];
    const Matrix3d& R = x[coordinates_.links()[k].slot].R;
    body.inertia.A = body.mass * Matrix3d::Identity();
    body.inertia.B.setZero();
    body.inertia.C.noalias() = R * body.own * R.transpose();
  }
}

bool ArticulatedBodies::factor(const Configuration& x) {
  place_inertias(x);
  for (std::size_t k = bodies_.size(); k-- > 0;) {
    if (!factor_joint(k)) return false;
    if (coordinates_.links()[k].parent >= 0) add_to_parent(k);
  }
  return true;
}

bool ArticulatedBodies::factor_joint(std::size_t k) {
  Body& body = bodies_[k];
  const auto& S = coordinates_.motions()[k].S;
  const JointCoordinates::Link& link = coordinates_.links()[k];
  const auto n = static_cast<std::size_t>(link.open);
  auto& L = body.L;
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    body.V[i] = body.inertia.times(S[i]);
    const double whole = dot(S[i], body.V[i]) + armature(link, i);
    double pivot = whole;
    for (std::size_t j = 0; j < i; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      L(row, column) = dot(S[i], body.V[j]);
      pivot -= L(row, column) * L(row, column);
      add(-L(row, column), body.V[j], body.V[i]);
    }
    if (!(pivot > 1e-14 * whole)) return false;
    const double inverse = 1.0 / std::sqrt(pivot);
    L(row, row) = inverse;
    body.V[i].v *= inverse;
    body.V[i].w *= inverse;
  }
  return true;
}

/// Inertia that the joint transmits, moved into the parent's centre.
void ArticulatedBodies::add_to_parent(std::size_t k) {
  const JointCoordinates::Link& link = coordinates_.links()[k];
  const Body& body = bodies_[k];
  Inertia left = body.inertia;
  for (int i = 0; i < link.open; ++i) {
    const Twist& V = body.V[static_cast<std::size_t>(i)];
    left.A.noalias() -= V.v * V.v.transpose();
    left.B.noalias() -= V.v * V.w.transpose();
    left.C.noalias() -= V.w * V.w.transpose();
  }
  const Vector3d& r = coordinates_.motions()[k].shift;
  const Matrix3d rB = -times_cross(left.B.transpose(), r).transpose();
  left.B -= times_cross(left.A, r);
  Inertia& parent = bodies_[static_cast<std::size_t>(link.parent)].inertia;
  parent.A += left.A;
  parent.B += left.B;
  // [r]× B' − Bᵀ [r]×, B' = B − A [r]×
  const Matrix3d rA = -times_cross(left.A, r).transpose();  // A is symmetric
  parent.C += left.C + rB + rB.transpose() - times_cross(rA, r);
}

void ArticulatedBodies::accelerate(const std::vector<SpatialForce>& wrenches,
                                   const Configuration& x,
                                   const std::vector<Twist>* twists,
                                   double* u_rate) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Body& body = bodies_[k];
    const std::size_t slot = coordinates_.links()[k].slot;
    body.force = {-wrenches[slot].v, -wrenches[slot].w};
    if (twists == nullptr) continue;
    const Vector3d& w = (*twists)[slot].w;
    const Matrix3d& R = x[slot].R;
    body.force.w += w.cross(R * (body.own * (R.transpose() * w)));
  }
  sweep_inwards(twists != nullptr);
  sweep_outwards(twists != nullptr, u_rate);
}

void ArticulatedBodies::sweep_inwards(bool with_bias) {
  for (std::size_t k = bodies_.size(); k-- > 0;) {
    const JointCoordinates::Link& link = coordinates_.links()[k];
    const JointCoordinates::Motion& motion = coordinates_.motions()[k];
    Body& body = bodies_[k];
    if (with_bias) add(1.0, body.inertia.times(motion.bias), body.force);
    for (int i = 0; i < link.open; ++i) {
      double left = -dot(motion.S[static_cast<std::size_t>(i)], body.force);
      for (int j = 0; j < i; ++j) left -= body.L(i, j) * body.left[j];
      body.left[i] = left * body.L(i, i);
    }
    if (link.parent < 0) continue;
    SpatialForce force = body.force;
    for (int i = 0; i < link.open; ++i) {
      add(body.left[i], body.V[static_cast<std::size_t>(i)], force);
    }
    force.w += motion.shift.cross(force.v);
    add(1.0, force, bodies_[static_cast<std::size_t>(link.parent)].force);
  }
}

void ArticulatedBodies::sweep_outwards(bool with_bias, double* u_rate) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const JointCoordinates::Link& link = coordinates_.links()[k];
    const JointCoordinates::Motion& motion = coordinates_.motions()[k];
    Body& body = bodies_[k];
    Twist& a = body.acceleration;
    a = {};
    if (link.parent >= 0) {
      const auto parent = static_cast<std::size_t>(link.parent);
      a = bodies_[parent].acceleration;
      if (with_bias) add(1.0, coordinates_.motions()[parent].bias, a);
      a.v += a.w.cross(motion.shift);
    }
    auto& rate = body.left;
    for (int i = link.open; i-- > 0;) {
      double value = body.left[i] - dot(body.V[static_cast<std::size_t>(i)], a);
      for (int j = i + 1; j < link.open; ++j) value -= body.L(j, i) * rate[j];
      rate[i] = value * body.L(i, i);
      u_rate[link.u + link.order[static_cast<std::size_t>(i)]] = rate[i];
    }
    for (int i = 0; i < link.open; ++i) {
      add(rate[i], motion.S[static_cast<std::size_t>(i)], a);
    }
  }
}

double ArticulatedBodies::drive_power(const double* u,
                                      const double* u_rate) const {
  double power = 0.0;
  for (const JointCoordinates::Driven& driven : coordinates_.driven()) {
    const JointCoordinates::Link& link = coordinates_.links()[driven.link];
    const Body& body = bodies_[driven.link];
    SpatialForce force = body.inertia.times(body.acceleration);
    add(1.0, body.force, force);
    for (int j = link.open; j < link.count; ++j) {
      const auto at = static_cast<std::size_t>(j);
      if (link.u + link.order[at] != driven.u) continue;
      const double effort =
          dot(coordinates_.motions()[driven.link].S[at], force) +
          armature(link, at) * u_rate[driven.u];
      power += effort * u[driven.u];
    }
  }
  return power;
}

}  // namespace clevis::mechanism
