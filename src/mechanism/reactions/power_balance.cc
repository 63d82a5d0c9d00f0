#include "mechanism/reactions/power_balance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "base/values/round_off_length.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Power {
  double sum{};
  double largest_term{};
  double gross{};  ///< largest force times speed, whatever their directions

  void add(double term) { add(term, std::abs(term)); }
  void add(double term, double product) {
    sum += term;
    largest_term = std::max(largest_term, std::abs(term));
    gross = std::max(gross, product);
  }
};

/// [m]
double extent(const MechanismDefinition& definition) {
  double length = 0.0;
  for (const JointDefinition& joint : definition.joints) {
    length = std::max({length, joint.frame_a.p_LJ.norm(),
                       joint.frame_b.p_LJ.norm(), joint.length});
  }
  for (const BodyDefinition& body : definition.bodies) {
    length = std::max(length, body.mass_properties.p_LCm.norm());
  }
  return length > kRoundOffLength ? length : 1.0;
}

/// @param slow  a speed too low to matter [m/s].
Power power(const MechanismDefinition& definition, const Instant& instant,
            double slow) {
  Power result;
  for (const DriveState& drive : instant.drives) {
    result.add(drive.effort * drive.rate);
  }
  for (const ElementState& element : instant.elements) {
    result.add(element.power);
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
    const double speed = v.norm() + slow;
    result.add(mass.mass * definition.gravity_W.dot(v),
               mass.mass * definition.gravity_W.norm() * speed);
    // d(½ m v² + ½ ωᵀ I ω)/dt; the turn of I itself does no work
    result.add(-mass.mass * v.dot(a), mass.mass * a.norm() * speed);
    result.add(-w.dot(inertia * body.alpha_WL), w.dot(inertia * w) * w.norm());
  }
  return result;
}

}  // namespace

void judge_power_balance(const MechanismDefinition& definition,
                         Motion& motion) {
  // of the largest power, or of what forces across the motion would do: in
  // steady motions there is nothing else
  constexpr double kAcross = 1e-6, kSlow = 1e-3;
  const double duration = motion.instants.back().t;
  const double slow =
      duration > 0.0 ? kSlow * extent(definition) / duration : 0.0;
  double scale = 0.0;
  for (Instant& instant : motion.instants) {
    if (instant.is_change_point) continue;  // in balance when deflected
    const Power p = power(definition, instant, slow);
    instant.power_balance_error = std::abs(p.sum);
    scale = std::max({scale, p.largest_term, kAcross * p.gross});
  }
  for (Instant& instant : motion.instants) {
    if (scale > 0.0) instant.power_balance_error /= scale;
  }
}

}  // namespace clevis::mechanism
