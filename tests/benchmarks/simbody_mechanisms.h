#pragma once

#include <algorithm>
#include <cmath>

#include <Simbody.h>

#include "benchmarks/reference_trajectories.h"
#include "benchmarks/simbody_mechanism.h"
#include "support/bricard_equations.h"
#include "support/governor_equations.h"

/// The mechanisms of work_precision.cc in Simbody: trees of joints, the loops
/// closed by constraints.
namespace clevis::benchmarks {

class SimbodyPendulum : public SimbodyMechanism {
 public:
  SimbodyPendulum() {
    gravity({0, -9.81, 0});
    auto& bob = add(SimTK::MobilizedBody::Pin(
        ground(), SimTK::Transform(),
        rigid(1.0, {1, 0, 0}, Vec3(1e-14, 1e-14, 1e-14)), SimTK::Transform()));
    state_ = system_.realizeTopology();
    bob.setOneQ(state_, 0, M_PI);
  }

 protected:
  void look(const SimTK::State& now, Sample& sample) const override {
    sample.point = plain(at(bodies_[0], now, {1, 0, 0}));
  }
};

/// Three upright bars on ground under two level ones.
class SimbodyFourBar : public SimbodyMechanism {
 public:
  SimbodyFourBar() {
    gravity({0, -9.81, 0});
    bodies_.reserve(5);
    const auto pin = [this](SimTK::MobilizedBody& parent, const Vec3& where) {
      add(SimTK::MobilizedBody::Pin(parent, SimTK::Transform(where),
                                    uniform_bar(), SimTK::Transform()));
    };
    for (int i = 0; i < 3; ++i) pin(ground(), Vec3(i, 0, 0));
    for (std::size_t i = 0; i < 2; ++i) pin(bodies_[i], Vec3(1, 0, 0));
    for (std::size_t i = 0; i < 2; ++i) {  // ends of level on upright bars
      const Vec3 end(1, 0, 0);
      SimTK::Constraint::PointInPlane(bodies_[i + 1],
                                      SimTK::UnitVec3(SimTK::XAxis), 1.0,
                                      bodies_[i + 3], end);
      SimTK::Constraint::PointInPlane(bodies_[i + 1],
                                      SimTK::UnitVec3(SimTK::YAxis), 0.0,
                                      bodies_[i + 3], end);
    }
    state_ = system_.realizeTopology();
    for (std::size_t i = 0; i < 5; ++i) {
      const double sign = i < 3 ? 1.0 : -1.0;
      bodies_[i].setOneQ(state_, 0, sign * 0.5 * M_PI);
      bodies_[i].setOneU(state_, 0, -sign);
    }
  }

 protected:
  void look(const SimTK::State& now, Sample& sample) const override {
    sample.point = plain(at(bodies_[0], now, {1, 0, 0}));
    for (std::size_t k = 1; k < 3; ++k) {
      const double apart =
          bodies_[k].getOneQ(now, 0) - bodies_[0].getOneQ(now, 0);
      sample.branch =
          std::max(sample.branch, std::abs(std::remainder(apart, 2.0 * M_PI)));
    }
  }
};

/// Crank on ground; slider on ground with the rod on a universal joint, the
/// rod's ball on the crank.
class SimbodySliderCrank : public SimbodyMechanism {
 public:
  SimbodySliderCrank() {
    gravity({0, 0, -9.81});
    bodies_.reserve(3);
    const SimTK::Rotation z_to_x(0.5 * M_PI, SimTK::YAxis);
    const Vec3 pivot(0, 0.1, 0.12), ball(0, 0.1, 0.2), end(0.2, 0, 0);
    add(SimTK::MobilizedBody::Pin(
        ground(), SimTK::Transform(z_to_x, pivot),
        rigid(0.12, {0, 0, 0.04}, Vec3(1e-4, 1e-4, 1e-4)),
        SimTK::Transform(z_to_x)));
    auto& slider = add(SimTK::MobilizedBody::Slider(
        ground(), SimTK::Transform(),
        rigid(2.0, {0, 0, 0}, Vec3(1e-3, 1e-3, 1e-3)), SimTK::Transform()));
    // rod: x from its ball to its end, y across the world's x
    const SimTK::UnitVec3 x(end - ball), y(SimTK::cross(Vec3(1, 0, 0), x));
    const SimTK::Rotation rod(x, SimTK::XAxis, y, SimTK::YAxis);
    // Simbody's universal joint turns about x of its frame, then about y
    const SimTK::Rotation start(SimTK::UnitVec3(1, 0, 0), SimTK::XAxis, y,
                                SimTK::YAxis);
    add(SimTK::MobilizedBody::Universal(
        slider, SimTK::Transform(start),
        rigid(0.5, {0.15, 0, 0}, Vec3(4e-4, 4e-3, 4e-3)),
        SimTK::Transform(~rod * start, Vec3(0.3, 0, 0))));
    SimTK::Constraint::Ball(bodies_[0], Vec3(0, 0, 0.08), bodies_[2],
                            Vec3(0, 0, 0));
    state_ = system_.realizeTopology();
    bodies_[1].setOneQ(state_, 0, 0.2);
    make_consistent(6.0);
  }

 protected:
  void look(const SimTK::State& now, Sample& sample) const override {
    sample.point.x() = at(bodies_[1], now, Vec3(0))[0];
  }
};

class SimbodyGovernor : public SimbodyMechanism {
 public:
  SimbodyGovernor() {
    conservative_ = false;
    const mechanism::testing::Governor v;
    gravity({0, 0, -v.g});
    bodies_.reserve(4);
    const Vec3 spin(v.shaft_spin, v.shaft_spin, v.shaft_spin);
    add(SimTK::MobilizedBody::Pin(ground(), SimTK::Transform(),
                                  rigid(1.0, Vec3(0), spin),
                                  SimTK::Transform()));
    const SimTK::Rotation x_to_z(-0.5 * M_PI, SimTK::YAxis);
    add(SimTK::MobilizedBody::Slider(
        bodies_[0], SimTK::Transform(x_to_z),
        rigid(v.sleeve_mass, Vec3(0),
              Vec3(v.sleeve_spin, v.sleeve_spin, v.sleeve_spin)),
        SimTK::Transform(x_to_z)));
    const SimTK::Rotation z_to_y(-0.5 * M_PI, SimTK::XAxis);
    for (std::size_t i = 0; i < 2; ++i) {
      add(SimTK::MobilizedBody::Pin(
          bodies_[0], SimTK::Transform(z_to_y),
          rigid(v.arm_mass, {0, 0, -v.arm_centre},
                {v.arm_transverse, v.arm_transverse, v.arm_axial}),
          SimTK::Transform(z_to_y)));
      const Vec3 middle(0, 0, -v.middle);
      SimTK::Force::TwoPointLinearSpring(forces_, bodies_[i + 2], middle,
                                         bodies_[1], Vec3(0), v.stiffness,
                                         v.free);
      SimTK::Force::TwoPointLinearDamper(forces_, bodies_[i + 2], middle,
                                         bodies_[1], Vec3(0), v.damping);
    }
    state_ = system_.realizeTopology();
    bodies_[0].setOneU(state_, 0, v.spin);
    bodies_[1].setOneQ(state_, 0, -v.start_depth());
    bodies_[2].setOneQ(state_, 0, v.angle);
    bodies_[3].setOneQ(state_, 0, -v.angle);
  }

 protected:
  void look(const SimTK::State& now, Sample& sample) const override {
    sample.point.z() = at(bodies_[1], now, Vec3(0))[2];
  }
};

/// Five bars one on the other; the last hinge a ball and two right angles.
class SimbodyBricard : public SimbodyMechanism {
 public:
  SimbodyBricard() {
    using mechanism::testing::bricard_axes;
    gravity({0, -9.81, 0});
    bodies_.reserve(5);
    for (std::size_t i = 0; i < 5; ++i) {
      SimTK::MobilizedBody& before = i == 0 ? ground() : bodies_[i - 1];
      const Eigen::Matrix3d R =
          i == 0 ? bricard_axes(0)
                 : Eigen::Matrix3d(bricard_axes(i - 1).transpose() *
                                   bricard_axes(i));
      const Vec3 where(i == 0 ? 0.0 : 1.0, 0, 0);
      add(SimTK::MobilizedBody::Pin(before, SimTK::Transform(turned(R), where),
                                    uniform_bar(), SimTK::Transform()));
    }
    const auto axes = turned(bricard_axes(5));  // z: the last hinge
    SimTK::Constraint::Ball(ground(), Vec3(0, 0, 1), bodies_[4], Vec3(1, 0, 0));
    const SimTK::UnitVec3 hinge(~turned(bricard_axes(4)) * Vec3(axes.z()));
    SimTK::Constraint::ConstantAngle(ground(), axes.x(), bodies_[4], hinge);
    SimTK::Constraint::ConstantAngle(ground(), axes.y(), bodies_[4], hinge);
    state_ = system_.realizeTopology();
  }

 protected:
  void look(const SimTK::State& now, Sample& sample) const override {
    const auto along = [&](std::size_t bar) {
      return Vec3(bodies_[bar].getBodyRotation(now).x());
    };
    const double a = SimTK::dot(along(0), along(1)),
                 b = SimTK::dot(along(1), along(2));
    sample.point = plain(at(bodies_[3], now, Vec3(0)));
    sample.branch = std::abs(a + b + a * b);
  }
};

}  // namespace clevis::benchmarks
