#include "scene/force_elements/read_constant.h"

namespace clevis::scene {

mechanism::ForceElement read_constant(StrictTable& table, const Names& names) {
  mechanism::ConstantForce force;
  const Value body = table["body"];
  force.point.body = names.bodies.find(body.name(), body);
  force.point.p_L = table["point"].vector(Dimension::kLength);
  force.f_W = table["force"].vector(Dimension::kForce);
  if (const auto moment = table.find("moment")) {
    force.t_W = moment->vector(Dimension::kTorque);
  }
  return force;
}

}  // namespace clevis::scene
