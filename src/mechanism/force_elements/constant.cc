#include "mechanism/force_elements/constant.h"

#include "mechanism/element_base/acting_element.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

class Constant final : public ActingElement {
 public:
  Constant(const ConstantForce& force, const ReferenceFrame& frame) {
    R_PW = frame.R_WP.transpose();
    join({.body = kGround}, force.point, frame);
    f_ = R_PW * force.f_W;
    t_ = R_PW * force.t_W;
  }

 protected:
  void act(const ActingState& /*state*/, const Twist& /*a*/, const Twist& b,
           ElementResponse& now) const override {
    const Vector3d& r_b = now.placed.r_b;
    const Vector3d v = b.v + b.w.cross(r_b);
    now.effort = f_.norm();
    now.rate = now.effort > 0.0 ? f_.dot(v) / now.effort : 0.0;
    now.on_b = {f_, r_b.cross(f_) + t_};
  }

 private:
  Vector3d f_, t_;  ///< in P
};

}  // namespace

ElementProperties properties(const ConstantForce& force) {
  return {.type = "constant", .fixed_force_W = force.f_W};
}

std::unique_ptr<ActingElement> place(const ConstantForce& force,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Constant>(force, frame);
}

}  // namespace clevis::mechanism
