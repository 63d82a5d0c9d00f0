#pragma once

#include <string>
#include <vector>

#include "benchmarks/mujoco_mechanism.h"
#include "support/planar_linkage.h"

namespace clevis::benchmarks {

/// A planar linkage in MuJoCo: a tree of hinges, every further joint a
/// `connect`.
class MujocoLinkage : public MujocoMechanism {
 public:
  using Linkage = mechanism::testing::PlanarLinkage;
  using Joint = mechanism::testing::PlanarJoint;

  explicit MujocoLinkage(const Linkage& linkage)
      : MujocoMechanism({0.0, -linkage.gravity, 0.0}, world(linkage),
                        conditions(linkage)),
        linkage_(linkage) {
    conservative_ = linkage.turned < 0;
    const std::vector<bool> closes = linkage.closures();
    for (std::size_t j = 0; j < closes.size(); ++j) {
      const Joint& joint = linkage.joints[j];
      if (closes[j]) continue;
      const int body = body_of(joint.b);
      const int address = model().jnt_dofadr[model().body_jntadr[body]];
      u_[static_cast<std::size_t>(address)] = linkage.rate(joint);
    }
  }

 protected:
  void apply() const override {
    if (linkage_.turned < 0) return;
    // force, then moment, in the world
    data().xfrc_applied[6 * body_of(linkage_.turned) + 5] = linkage_.torque;
  }

  void look(Sample& sample) const override {
    const Eigen::Vector3d way = axes(body_of(linkage_.pointer)).col(0);
    sample.point = {way.x(), way.y(), 0.0};
    if (linkage_.slider >= 0) {
      sample.point.z() = origin(body_of(linkage_.slider)).x();
    }
    sample.pin = -1.0;
  }

 private:
  static std::size_t index(int body) { return static_cast<std::size_t>(body); }
  static Eigen::Vector3d at(const Eigen::Vector2d& p) {
    return {p.x(), p.y(), 0.0};
  }

  int body_of(int i) const {
    return mj_name2id(&model(), mjOBJ_BODY,
                      linkage_.bodies[index(i)].name.c_str());
  }

  static std::string site(const std::string& name, const Eigen::Vector2d& p) {
    return "<site name=\"" + name + "\" pos=\"" + text(at(p)) + "\"/>";
  }

  /// Sites of the springs on a body; −1: on the ground.
  static std::string sites(const Linkage& m, int body) {
    std::string xml;
    for (std::size_t i = 0; i < m.springs.size(); ++i) {
      const auto& spring = m.springs[i];
      if (spring.a == body) xml += site("a" + std::to_string(i), spring.p_a);
      if (spring.b == body) xml += site("b" + std::to_string(i), spring.p_b);
    }
    return xml;
  }

  /// What hangs on a body. MuJoCo's bodies have their origin where they are
  /// said to be at the start, their joint at p_b.
  static std::string hanging(const Linkage& m, int parent) {
    std::string xml;
    const std::vector<bool> closes = m.closures();
    for (std::size_t j = 0; j < closes.size(); ++j) {
      const Joint& joint = m.joints[j];
      if (closes[j] || joint.a != parent) continue;
      const auto& b = m.bodies[index(joint.b)];
      const double before = parent < 0 ? 0.0 : m.bodies[index(parent)].angle;
      const Eigen::Matrix3d R =
          Eigen::AngleAxisd(b.angle - before, Eigen::Vector3d::UnitZ())
              .toRotationMatrix();
      const Eigen::Vector3d origin = at(joint.p_a) - R * at(joint.p_b);
      xml +=
          "<body name=\"" + b.name + "\" pos=\"" + text(origin) + "\"" +
          benchmarks::turned(R) + ">" +
          (joint.slides ? "<joint type=\"slide\" axis=\"1 0 0\"/>"
                        : "<joint type=\"hinge\" axis=\"0 0 1\" pos=\"" +
                              text(at(joint.p_b)) + "\"/>") +
          inertial(b.mass, at(b.centre), Eigen::Vector3d::Constant(b.inertia)) +
          sites(m, joint.b) + hanging(m, joint.b) + "</body>";
    }
    return xml;
  }

  static std::string world(const Linkage& m) {
    return sites(m, -1) + hanging(m, -1);
  }

  static std::string conditions(const Linkage& m) {
    std::string equal, tendons;
    const std::vector<bool> closes = m.closures();
    for (std::size_t j = 0; j < closes.size(); ++j) {
      if (!closes[j]) continue;
      const Joint& joint = m.joints[j];
      equal += "<connect body1=\"" + m.bodies[index(joint.b)].name +
               "\" body2=\"" + m.bodies[index(joint.a)].name + "\" anchor=\"" +
               text(at(joint.p_b)) + "\"/>";
    }
    for (std::size_t i = 0; i < m.springs.size(); ++i) {
      tendons += "<spatial stiffness=\"" + text(m.springs[i].stiffness) +
                 "\" springlength=\"" + text(m.springs[i].free) +
                 "\"><site site=\"a" + std::to_string(i) +
                 "\"/><site site=\"b" + std::to_string(i) + "\"/></spatial>";
    }
    if (!equal.empty()) equal = "<equality>" + equal + "</equality>";
    if (!tendons.empty()) tendons = "<tendon>" + tendons + "</tendon>";
    return equal + tendons;
  }

  Linkage linkage_;
};

}  // namespace clevis::benchmarks
