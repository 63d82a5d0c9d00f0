#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "benchmarks/mujoco_mechanism.h"
#include "benchmarks/reference_trajectories.h"
#include "support/bricard_equations.h"
#include "support/governor_equations.h"

/// The mechanisms of work_precision.cc in MuJoCo: trees of joints, the loops
/// closed by its `connect` constraints, which are soft.
namespace clevis::benchmarks {

class MujocoPendulum : public MujocoMechanism {
 public:
  MujocoPendulum()
      : MujocoMechanism(
            {0.0, -9.81, 0.0},
            "<body>" + hinge({0.0, 0.0, 1.0}) +
                inertial(1.0, {1.0, 0.0, 0.0}, {1e-14, 1e-14, 1e-14}) +
                "</body>",
            "") {
    q_[0] = M_PI;
  }

 protected:
  void look(Sample& sample) const override {
    sample.point = origin(1) + axes(1).col(0);
  }
};

/// Three upright bars on ground under two level ones; bodies 1 and 3 the first
/// two upright ones, each with its level one behind it.
class MujocoFourBar : public MujocoMechanism {
 public:
  MujocoFourBar()
      : MujocoMechanism(
            {0.0, -9.81, 0.0},
            upright(0, level("level_0")) + upright(1, level("level_1")) +
                upright(2, ""),
            "<equality><connect body1=\"level_0\" body2=\"upright_1\" "
            "anchor=\"1 0 0\"/><connect body1=\"level_1\" "
            "body2=\"upright_2\" anchor=\"1 0 0\"/></equality>") {
    u_ = {-1.0, 1.0, -1.0, 1.0, -1.0};
  }

 protected:
  void look(Sample& sample) const override {
    sample.point = origin(1) + axes(1).col(0);
    for (const int body : {3, 5}) {
      const double apart = (axes(body) - axes(1)).norm();
      sample.branch = std::max(sample.branch, apart / M_SQRT2);
    }
  }

 private:
  static std::string level(const std::string& name) {
    const Eigen::Matrix3d down =
        Eigen::AngleAxisd(-0.5 * M_PI, Eigen::Vector3d::UnitZ())
            .toRotationMatrix();
    return "<body name=\"" + name + "\" pos=\"1 0 0\"" + turned(down) + ">" +
           hinge({0.0, 0.0, 1.0}) + uniform_bar() + "</body>";
  }
  static std::string upright(int i, const std::string& child) {
    const Eigen::Matrix3d up =
        Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitZ())
            .toRotationMatrix();
    return "<body name=\"upright_" + std::to_string(i) + "\" pos=\"" +
           std::to_string(i) + " 0 0\"" + turned(up) + ">" +
           hinge({0.0, 0.0, 1.0}) + uniform_bar() + child + "</body>";
  }
};

/// Crank on ground; slider on ground with the rod on two hinges, the rod's
/// ball on the crank.
class MujocoSliderCrank : public MujocoMechanism {
 public:
  MujocoSliderCrank()
      : MujocoMechanism(
            {0.0, 0.0, -9.81},
            "<body name=\"crank\" pos=\"0 0.1 0.12\">" +
                hinge({1.0, 0.0, 0.0}) +
                inertial(0.12, {0.0, 0.0, 0.04}, {1e-4, 1e-4, 1e-4}) +
                "</body><body pos=\"0.2 0 0\">" +
                "<joint type=\"slide\" axis=\"1 0 0\"/>" +
                inertial(2.0, {0.0, 0.0, 0.0}, {1e-3, 1e-3, 1e-3}) + rod() +
                "</body>",
            "<equality><connect body1=\"rod\" body2=\"crank\" "
            "anchor=\"-0.3 0 0\"/></equality>") {
    make_consistent(6.0);
  }

 protected:
  void look(Sample& sample) const override { sample.point.x() = origin(2).x(); }

 private:
  /// x from its ball to its end, where its origin is; y across the world's x.
  static std::string rod() {
    Eigen::Matrix3d R;
    R.col(0) = Eigen::Vector3d(0.2, -0.1, -0.2).normalized();
    R.col(1) = Eigen::Vector3d::UnitX().cross(R.col(0)).normalized();
    R.col(2) = R.col(0).cross(R.col(1));
    return "<body name=\"rod\"" + turned(R) + ">" +
           hinge(R.transpose().col(0)) + hinge({0.0, 1.0, 0.0}) +
           inertial(0.5, {-0.15, 0.0, 0.0}, {4e-4, 4e-3, 4e-3}) + "</body>";
  }
};

/// The springs are tendons.
class MujocoGovernor : public MujocoMechanism {
 public:
  MujocoGovernor()
      : MujocoMechanism({0.0, 0.0, -governor_.g}, world(), springs()) {
    conservative_ = false;
    u_[0] = governor_.spin;
  }

 protected:
  void look(Sample& sample) const override { sample.point.z() = origin(2).z(); }

 private:
  static std::string world() {
    const mechanism::testing::Governor v;
    std::string xml = "<body>" + hinge({0.0, 0.0, 1.0}) +
                      inertial(1.0, {0.0, 0.0, 0.0},
                               Eigen::Vector3d::Constant(v.shaft_spin)) +
                      "<body pos=\"0 0 " + text(-v.start_depth()) +
                      "\"><joint type=\"slide\" axis=\"0 0 1\"/>" +
                      inertial(v.sleeve_mass, {0.0, 0.0, 0.0},
                               Eigen::Vector3d::Constant(v.sleeve_spin)) +
                      "<site name=\"sleeve\"/></body>";
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Matrix3d R =
          Eigen::AngleAxisd(-side * v.angle, Eigen::Vector3d::UnitY())
              .toRotationMatrix();
      xml += "<body" + turned(R) + ">" + hinge({0.0, 1.0, 0.0}) +
             inertial(v.arm_mass, {0.0, 0.0, -v.arm_centre},
                      {v.arm_transverse, v.arm_transverse, v.arm_axial}) +
             "<site name=\"middle" + text(side) + "\" pos=\"0 0 " +
             text(-v.middle) + "\"/></body>";
    }
    return xml + "</body>";
  }
  static std::string springs() {
    const mechanism::testing::Governor v;
    std::string xml = "<tendon>";
    for (const double side : {-1.0, 1.0}) {
      xml += "<spatial stiffness=\"" + text(v.stiffness) + "\" damping=\"" +
             text(v.damping) + "\" springlength=\"" + text(v.free) +
             "\"><site site=\"sleeve\"/><site site=\"middle" + text(side) +
             "\"/></spatial>";
    }
    return xml + "</tendon>";
  }

  static inline const mechanism::testing::Governor governor_{};
};

/// Five bars one on the other; the last hinge two points of the world.
class MujocoBricard : public MujocoMechanism {
 public:
  MujocoBricard() : MujocoMechanism({0.0, -9.81, 0.0}, bars(), last_hinge()) {}

 protected:
  void look(Sample& sample) const override {
    const double a = axes(1).col(0).dot(axes(2).col(0)),
                 b = axes(2).col(0).dot(axes(3).col(0));
    sample.point = origin(4);
    sample.branch = std::abs(a + b + a * b);
  }

 private:
  static std::string bars() {
    using mechanism::testing::bricard_axes;
    std::string xml, end;
    for (std::size_t i = 0; i < 5; ++i) {
      const Eigen::Matrix3d R =
          i == 0 ? bricard_axes(0)
                 : Eigen::Matrix3d(bricard_axes(i - 1).transpose() *
                                   bricard_axes(i));
      xml += "<body name=\"bar_" + std::to_string(i) + "\" pos=\"" +
             (i == 0 ? "0 0 0" : "1 0 0") + "\"" + turned(R) + ">" +
             hinge({0.0, 0.0, 1.0}) + uniform_bar();
      end += "</body>";
    }
    return xml + end;
  }
  static std::string last_hinge() {
    using mechanism::testing::bricard_axes;
    const Eigen::Vector3d axis =
        bricard_axes(4).transpose() * bricard_axes(5).col(2);
    const Eigen::Vector3d end = Eigen::Vector3d::UnitX();
    const auto held = [](const Eigen::Vector3d& p) {
      return "<connect body1=\"bar_4\" anchor=\"" + text(p) + "\"/>";
    };
    return "<equality>" + held(end) + held(Eigen::Vector3d(end + axis)) +
           "</equality>";
  }
};

}  // namespace clevis::benchmarks
