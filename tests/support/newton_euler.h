#pragma once

#include <algorithm>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mechanism/definition/drive_names.h"
#include "mechanism/definition/motion.h"
#include "mechanism/joints/joint_types.h"

/// Newton–Euler balance of every body, recomputed from what is printed:
/// poses, accelerations, reactions, efforts of drives and couplings in W.
namespace clevis::mechanism::testing {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Balance {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();  // about Cm
  double scale = 0.0;

  void add(const Vector3d& f, const Vector3d& lever, const Vector3d& t) {
    force += f;
    moment += lever.cross(f) + t;
    scale = std::max({scale, f.norm(), t.norm() / 0.1});
  }
};

/// Largest residual over its body's largest force.
inline double imbalance(const MechanismDefinition& m, const Instant& at) {
  double worst = 0.0;
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    const auto& mass = m.bodies[i].mass_properties;
    const BodyState& body = at.bodies[i];
    const Matrix3d& R = body.pose.R_WL;
    const Vector3d c = R * mass.p_LCm;
    const Vector3d p_WCm = body.pose.p_WL + c;
    const Vector3d& w = body.w_WL;
    Balance sum;
    sum.add(mass.mass * m.gravity_W, Vector3d::Zero(), Vector3d::Zero());
    const Vector3d a_Cm =
        body.a_WLo + body.alpha_WL.cross(c) + w.cross(Vector3d(w.cross(c)));
    const Matrix3d inertia = R * mass.inertia_LCm * R.transpose();
    sum.add(-mass.mass * a_Cm, Vector3d::Zero(),
            -(inertia * body.alpha_WL + w.cross(Vector3d(inertia * w))));
    for (std::size_t j = 0; j < m.joints.size(); ++j) {
      const JointReaction& r = at.joints[j];
      const Vector3d lever = r.p_WJ - p_WCm;
      const auto self = static_cast<int>(i);
      if (m.joints[j].body_b == self) sum.add(r.f_W, lever, r.t_W);
      if (m.joints[j].body_a == self) sum.add(-r.f_W, lever, -r.t_W);
    }
    for (std::size_t k = 0; k < m.drives.size(); ++k) {
      const auto j = static_cast<std::size_t>(m.drives[k].joint);
      const bool turns = drives_angle(m, m.drives[k]);
      const Vector3d e = at.drives[k].effort * at.drives[k].axis_W;
      const Vector3d f = turns ? Vector3d::Zero() : e;
      const Vector3d t = turns ? e : Vector3d::Zero();
      const Vector3d lever = at.joints[j].p_WJ - p_WCm;
      const auto self = static_cast<int>(i);
      if (m.joints[j].body_b == self) sum.add(f, lever, t);
      if (m.joints[j].body_a == self) sum.add(-f, lever, -t);
    }
    for (std::size_t k = 0; k < m.couplings.size(); ++k) {
      const CouplingState& mesh = at.couplings[k];
      const auto wrench = [&](int joint, const Vector3d& f, const Vector3d& t) {
        const auto j = static_cast<std::size_t>(joint);
        const Vector3d lever = at.joints[j].p_WJ - p_WCm;
        const auto self = static_cast<int>(i);
        if (m.joints[j].body_b == self) sum.add(f, lever, t);
        if (m.joints[j].body_a == self) sum.add(-f, lever, -t);
      };
      wrench(m.couplings[k].joint_1, mesh.f_1_W, mesh.t_1_W);
      wrench(m.couplings[k].joint_2, mesh.f_2_W, mesh.t_2_W);
    }
    for (const ForceElement& element : m.elements) {
      const auto* force = std::get_if<ConstantForce>(&element);
      if (force == nullptr || force->point.body != static_cast<int>(i))
        continue;
      sum.add(force->f_W, R * (force->point.p_L - mass.p_LCm), force->t_W);
    }
    worst = std::max({worst, sum.force.norm() / sum.scale,
                      sum.moment.norm() / (0.1 * sum.scale)});
  }
  return worst;
}

}  // namespace clevis::mechanism::testing
