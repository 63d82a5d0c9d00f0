#include "report/view/mechanism_energy.h"

#include <Eigen/Geometry>

namespace clevis::report {

MechanismEnergy mechanism_energy(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Instant& instant) {
  MechanismEnergy energy;
  for (std::size_t b = 0; b < instant.bodies.size(); ++b) {
    const auto& mass = definition.bodies[b].mass_properties;
    const mechanism::BodyState& body = instant.bodies[b];
    const Eigen::Matrix3d& R_WL = body.pose.R_WL;
    const Eigen::Vector3d p_LoCm_W = R_WL * mass.p_LCm;
    const Eigen::Vector3d v_WCm = body.v_WLo + body.w_WL.cross(p_LoCm_W);
    const Eigen::Vector3d w_L = R_WL.transpose() * body.w_WL;
    energy.kinetic += 0.5 * mass.mass * v_WCm.squaredNorm() +
                      0.5 * w_L.dot(mass.inertia_LCm * w_L);
    energy.potential -=
        mass.mass * definition.gravity_W.dot(body.pose.p_WL + p_LoCm_W);
  }
  return energy;
}

}  // namespace clevis::report
