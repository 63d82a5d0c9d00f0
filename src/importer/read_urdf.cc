#include "importer/read_urdf.h"

#include <utility>

#include <Eigen/Geometry>
#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include "base/messages/errors.h"

namespace clevis::importer {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Vector3d vector_of(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

Isometry3d pose_of(const urdf::Pose& pose) {
  Isometry3d result = Isometry3d::Identity();
  const urdf::Rotation& r = pose.rotation;
  result.linear() =
      Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  result.translation() = vector_of(pose.position);
  return result;
}

/// Keeps the first error, which liburdfdom only logs.
class FirstError : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*,
           int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && text_.empty()) {
      text_ = text;
    }
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

const char* word_of(int type) {
  switch (type) {
    case urdf::Joint::REVOLUTE:
      return "revolute";
    case urdf::Joint::CONTINUOUS:
      return "continuous";
    case urdf::Joint::PRISMATIC:
      return "prismatic";
    case urdf::Joint::FLOATING:
      return "floating";
    case urdf::Joint::PLANAR:
      return "planar";
    case urdf::Joint::FIXED:
      return "fixed";
    default:
      return "unknown";
  }
}

multibody::Link link_of(const urdf::Link& link, const Isometry3d& X_WL) {
  multibody::Link found;
  found.name = link.name;
  found.p_WL = X_WL.translation();
  found.R_WL = X_WL.linear();
  if (!link.inertial) return found;
  const urdf::Inertial& inertial = *link.inertial;
  const Isometry3d X_LI = pose_of(inertial.origin);
  Eigen::Matrix3d inertia;
  inertia << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,         //
      inertial.ixz, inertial.iyz, inertial.izz;
  found.mass = inertial.mass;
  found.p_LCm = X_LI.translation();
  found.inertia_LCm = X_LI.linear() * inertia * X_LI.linear().transpose();
  return found;
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  multibody::Model read(const urdf::ModelInterface& robot) {
    result_.name = robot.getName();
    const urdf::Link& root = *robot.getRoot();
    add(root, Isometry3d::Identity());
    if (result_.links.size() != robot.links_.size()) {
      throw Error(
          "S014", file_,
          fmt::format("{} of {} links hang on nothing but one another",
                      robot.links_.size() - result_.links.size(),
                      robot.links_.size()),
          "A URDF is a tree: remove a joint of the loop, or write SDF.");
    }
    if (root.name == "world" || result_.links.front().mass == 0.0) {
      result_.links.front().is_fixed = true;
      result_.told.push_back(
          fmt::format("link {}: taken for the ground", root.name));
    }
    return std::move(result_);
  }

 private:
  void add(const urdf::Link& link, const Isometry3d& X_WL) {
    result_.links.push_back(link_of(link, X_WL));
    for (const auto& joint : link.child_joints) add(*joint, link, X_WL);
    for (std::size_t i = 0; i < link.child_links.size(); ++i) {
      const urdf::Link& child = *link.child_links[i];
      add(child,
          X_WL * pose_of(child.parent_joint->parent_to_joint_origin_transform));
    }
  }

  void add(const urdf::Joint& joint, const urdf::Link& parent,
           const Isometry3d& X_WL) {
    const Isometry3d X_WJ =
        X_WL * pose_of(joint.parent_to_joint_origin_transform);
    if (joint.type == urdf::Joint::FLOATING) return;
    multibody::Joint found{.name = joint.name,
                           .type = word_of(joint.type),
                           .parent = parent.name,
                           .child = joint.child_link_name,
                           .point = X_WJ.translation(),
                           .axes = {}};
    if (joint.type != urdf::Joint::FIXED) {
      found.axes.push_back(axis_of(joint, X_WJ));
    }
    result_.joints.push_back(std::move(found));
  }

  multibody::Axis axis_of(const urdf::Joint& joint, const Isometry3d& X_WJ) {
    multibody::Axis axis;
    axis.direction = X_WJ.linear() * vector_of(joint.axis).normalized();
    const bool is_bounded = joint.type == urdf::Joint::REVOLUTE ||
                            joint.type == urdf::Joint::PRISMATIC;
    if (joint.limits && !is_bounded &&
        (joint.limits->lower != 0.0 || joint.limits->upper != 0.0)) {
      result_.told.push_back(fmt::format(
          "joint {}: {}, its limits {:g} and {:g} are left out", joint.name,
          word_of(joint.type), joint.limits->lower, joint.limits->upper));
    }
    if (joint.limits && is_bounded) {
      axis.lower = joint.limits->lower;
      axis.upper = joint.limits->upper;
      result_.told.push_back(fmt::format(
          "joint {}: URDF gives limits without stiffness; 1e8 and damping 1 "
          "assumed (N/m or N m/rad), as SDF does",
          joint.name));
    }
    if (joint.dynamics) {
      axis.damping = joint.dynamics->damping;
      axis.friction = joint.dynamics->friction;
    }
    return axis;
  }

  const std::string& file_;
  multibody::Model result_;
};

}  // namespace

multibody::Model read_urdf(const std::string& xml, const std::string& file) {
  FirstError handler;
  console_bridge::useOutputHandler(&handler);
  const urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(xml);
  console_bridge::noOutputHandler();
  if (!robot || !robot->getRoot()) {
    throw Error("S014", file,
                fmt::format("liburdfdom says: {}", handler.text()),
                "Repair the model, or export it again.");
  }
  return Reader(file).read(*robot);
}

}  // namespace clevis::importer
