#include "mechanism/force_elements/impedance.h"

#include "base/values/index.h"
#include "mechanism/element_base/acting_element.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

class Impedance final : public ActingElement {
 public:
  Impedance(const ImpedanceElement& impedance, const ReferenceFrame& frame)
      : impedance_(impedance) {
    R_PW = frame.R_WP.transpose();
    join({.body = kGround}, impedance.point, frame);
  }

  ElementSpring spring(const Configuration& x,
                       const ElementState& state) const override;

 protected:
  void act(const ActingState& state, const Twist& a, const Twist& b,
           ElementResponse& now) const override;

 private:
  const ImpedanceElement& impedance_;
};

void Impedance::act(const ActingState& state, const Twist& /*a*/,
                    const Twist& b, ElementResponse& now) const {
  const PlacedJoint& placed = now.placed;
  Vector3d target = impedance_.target_W, target_rate = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const numerics::CubicSpline& path = impedance_.path_W[index(k)];
    if (path.times.empty()) continue;
    const numerics::CubicSpline::Point at = path.at(state.t);
    target[k] = at.value;
    if (!impedance_.damps_absolute) target_rate[k] = at.rate;
  }
  const Vector3d off = placed.p_b - R_PW * target;
  const Vector3d slip = b.v + b.w.cross(placed.r_b) - R_PW * target_rate;
  const Vector3d f = -impedance_.stiffness * off - impedance_.damping * slip;
  now.q = off.norm();
  now.rate = slip.norm();
  now.effort = f.norm();
  now.on_b = {f, placed.r_b.cross(f)};
}

ElementSpring Impedance::spring(const Configuration& x,
                                const ElementState& /*state*/) const {
  const PlacedJoint placed = placed_in(x);
  ElementSpring found{
      .stiffness = impedance_.stiffness * Eigen::Matrix3d::Identity(),
      .damping = impedance_.damping * Eigen::Matrix3d::Identity()};
  for (int k = 0; k < 3; ++k) {
    const Vector3d along = Vector3d::Unit(k);
    found.directions.push_back({.b = {along, placed.r_b.cross(along)}});
  }
  return found;
}

}  // namespace

ElementProperties properties(const ImpedanceElement& impedance) {
  ElementProperties result{.type = "impedance", .free = 0.0};
  result.breaks = impedance.path_W[0].times;
  for (const numerics::CubicSpline& path : impedance.path_W) {
    if (!path.times.empty()) result.paths.push_back(&path);
  }
  return result;
}

std::unique_ptr<ActingElement> place(const ImpedanceElement& impedance,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Impedance>(impedance, frame);
}

}  // namespace clevis::mechanism
