#include "mechanism/power_balance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Power {
  double sum{};
  double largest_term{};

  void add(double term) {
    sum += term;
    largest_term = std::max(largest_term, std::abs(term));
  }
};

Power power(const MechanismDefinition& definition, const Instant& instant) {
  Power result;
  for (const DriveState& drive : instant.drives) {
    result.add(drive.effort * drive.rate);
  }
  for (const ElementState& element : instant.elements) {
    result.add(element.power);
  }
  for (const ForceDefinition& force : definition.forces) {
    const BodyState& body =
        instant.bodies[static_cast<std::size_t>(force.body)];
    const Vector3d lever = body.pose.R_WL * force.p_LP;
    result.add(force.f_W.dot(body.v_WLo + body.w_WL.cross(lever)) +
               force.t_W.dot(body.w_WL));
  }
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    const part::MassProperties& mass = definition.bodies[i].mass_properties;
    const BodyState& body = instant.bodies[i];
    const Matrix3d& R = body.pose.R_WL;
    const Vector3d c = R * mass.p_LCm;
    const Vector3d& w = body.w_WL;
    const Vector3d v = body.v_WLo + w.cross(c);
    const Vector3d a =
        body.a_WLo + body.alpha_WL.cross(c) + w.cross(w.cross(c));
    const Matrix3d inertia = R * mass.inertia_LCm * R.transpose();
    result.add(mass.mass * definition.gravity_W.dot(v));
    // d(½ m v² + ½ ωᵀ I ω)/dt; the turn of I itself does no work
    result.add(-mass.mass * v.dot(a));
    result.add(-w.dot(inertia * body.alpha_WL));
  }
  return result;
}

}  // namespace

void judge_power_balance(const MechanismDefinition& definition,
                         Motion& motion) {
  double scale = 0.0;
  for (Instant& instant : motion.instants) {
    if (instant.is_change_point) continue;  // in balance when deflected
    const Power p = power(definition, instant);
    instant.power_balance_error = std::abs(p.sum);
    scale = std::max(scale, p.largest_term);
  }
  for (Instant& instant : motion.instants) {
    if (scale > 0.0) instant.power_balance_error /= scale;
  }
}

}  // namespace clevis::mechanism
