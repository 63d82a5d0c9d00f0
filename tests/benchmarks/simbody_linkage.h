#pragma once

#include <cmath>
#include <vector>

#include "benchmarks/simbody_mechanism.h"
#include "support/planar_linkage.h"

namespace clevis::benchmarks {

/// A planar linkage in Simbody: a tree of pins, every further joint two points
/// on planes.
class SimbodyLinkage : public SimbodyMechanism {
 public:
  using Linkage = mechanism::testing::PlanarLinkage;
  using Joint = mechanism::testing::PlanarJoint;

  explicit SimbodyLinkage(const Linkage& linkage) : linkage_(linkage) {
    conservative_ = linkage.turned < 0;
    gravity({0, -linkage.gravity, 0});
    bodies_.resize(linkage.bodies.size());
    const std::vector<bool> closes = linkage.closures();
    for (std::size_t j = 0; j < closes.size(); ++j) {
      if (closes[j]) {
        close(linkage.joints[j]);
      } else {
        hang(linkage.joints[j]);
      }
    }
    for (const auto& spring : linkage.springs) {
      SimTK::Force::TwoPointLinearSpring(
          forces_, body(spring.a), at(spring.p_a), body(spring.b),
          at(spring.p_b), spring.stiffness, spring.free);
    }
    if (linkage.turned >= 0) {
      SimTK::Force::ConstantTorque(forces_, body(linkage.turned),
                                   Vec3(0, 0, linkage.torque));
    }
    state_ = system_.realizeTopology();
    for (std::size_t j = 0; j < closes.size(); ++j) {
      const Joint& joint = linkage.joints[j];
      if (closes[j] || joint.slides) continue;
      const double before =
          joint.a < 0 ? 0.0 : linkage.bodies[index(joint.a)].angle;
      const SimTK::MobilizedBody& on = bodies_[index(joint.b)];
      on.setOneQ(state_, 0, linkage.bodies[index(joint.b)].angle - before);
      on.setOneU(state_, 0, linkage.rate(joint));
    }
  }

 protected:
  void look(const SimTK::State& now, Sample& sample) const override {
    const Vec3 way = bodies_[index(linkage_.pointer)].getBodyRotation(now).x();
    sample.point = {way[0], way[1], 0.0};
    if (linkage_.slider >= 0) {
      sample.point.z() = SimbodyMechanism::at(bodies_[index(linkage_.slider)],
                                              now, Vec3(0))[0];
    }
    sample.pin = -1.0;
    if (linkage_.closures()[index(linkage_.watched)]) {
      sample.pin = std::hypot(closures_[0].getMultipliersAsVector(now)[0],
                              closures_[1].getMultipliersAsVector(now)[0]);
    }
  }

 private:
  static std::size_t index(int body) { return static_cast<std::size_t>(body); }
  static Vec3 at(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0}; }

  SimTK::MobilizedBody& body(int i) {
    return i < 0 ? ground() : bodies_[index(i)];
  }

  void hang(const Joint& joint) {
    const auto& values = linkage_.bodies[index(joint.b)];
    const auto mass =
        rigid(values.mass, at(values.centre), Vec3(values.inertia));
    if (joint.slides) {
      bodies_[index(joint.b)] = SimTK::MobilizedBody::Slider(
          body(joint.a), SimTK::Transform(), mass, SimTK::Transform());
    } else {
      bodies_[index(joint.b)] = SimTK::MobilizedBody::Pin(
          body(joint.a), SimTK::Transform(at(joint.p_a)), mass,
          SimTK::Transform(at(joint.p_b)));
    }
  }

  void close(const Joint& joint) {
    const bool watched =
        joint.name == linkage_.joints[index(linkage_.watched)].name;
    for (int axis = 0; axis < 2; ++axis) {
      const SimTK::UnitVec3 normal{SimTK::CoordinateAxis(axis)};
      const SimTK::Constraint::PointInPlane plane(
          body(joint.a), normal, SimTK::dot(Vec3(normal), at(joint.p_a)),
          body(joint.b), at(joint.p_b));
      if (watched) closures_.push_back(plane);
    }
  }

  Linkage linkage_;
  std::vector<SimTK::Constraint> closures_;  ///< of the watched joint
};

}  // namespace clevis::benchmarks
