#include "importer/read_sdf.h"

#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <sdf/sdf.hh>

#include "base/messages/errors.h"

namespace clevis::importer {
namespace {

using Eigen::Vector3d;
using ignition::math::Pose3d;

constexpr const char* kModelFrame = "__model__";

Vector3d vector_of(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}

Eigen::Matrix3d matrix_of(const ignition::math::Matrix3d& m) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      result(i, k) = m(std::size_t(i), std::size_t(k));
    }
  }
  return result;
}

Eigen::Matrix3d rotation_of(const Pose3d& pose) {
  return matrix_of(ignition::math::Matrix3d(pose.Rot()));
}

/// Names in SDF's words, as its files have them.
const char* word_of(sdf::JointType type) {
  switch (type) {
    case sdf::JointType::BALL:
      return "ball";
    case sdf::JointType::CONTINUOUS:
      return "continuous";
    case sdf::JointType::FIXED:
      return "fixed";
    case sdf::JointType::GEARBOX:
      return "gearbox";
    case sdf::JointType::PRISMATIC:
      return "prismatic";
    case sdf::JointType::REVOLUTE:
      return "revolute";
    case sdf::JointType::REVOLUTE2:
      return "revolute2";
    case sdf::JointType::SCREW:
      return "screw";
    case sdf::JointType::UNIVERSAL:
      return "universal";
    case sdf::JointType::INVALID:
      break;
  }
  return "unknown";
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  multibody::Model read(const std::string& xml) {
    sdf::ParserConfig config;
    config.SetFindCallback([](const std::string&) {
      return std::string();
    });
    sdf::Root root;
    require(root.LoadSdfString(xml, config));
    if (const sdf::World* world = root.WorldByIndex(0)) {
      result_.name = world->Name();
      result_.gravity = vector_of(world->Gravity());
      const std::uint64_t count = world->ModelCount();
      for (std::uint64_t m = 0; m < count; ++m) {
        const sdf::Model& model = *world->ModelByIndex(m);
        add(model, Pose3d::Zero, count > 1 ? model.Name() + "::" : "", false);
      }
    } else if (const sdf::Model* model = root.Model()) {
      result_.name = model->Name();
      add(*model, Pose3d::Zero, "", false);
    }
    return std::move(result_);
  }

 private:
  void require(const sdf::Errors& errors) const {
    if (errors.empty()) return;
    throw Error("S014", file_,
                fmt::format("libsdformat says: {}", errors.front().Message()),
                "Repair the model; what <include> names must stand in the "
                "file itself.");
  }

  template <typename Posed>
  Pose3d pose_in(const Posed& posed, const std::string& frame) const {
    Pose3d pose;
    require(posed.SemanticPose().Resolve(pose, frame));
    return pose;
  }

  void add(const sdf::Model& model, const Pose3d& around,
           const std::string& scope, bool is_fixed) {
    const Pose3d X_WM = around * pose_in(model, "");
    is_fixed = is_fixed || model.Static();
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
      add(*model.LinkByIndex(i), X_WM, scope, is_fixed);
    }
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
      add(*model.JointByIndex(i), X_WM, scope);
    }
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& nested = *model.ModelByIndex(i);
      add(nested, X_WM, scope + nested.Name() + "::", is_fixed);
    }
  }

  void add(const sdf::Link& link, const Pose3d& X_WM, const std::string& scope,
           bool is_fixed) {
    const Pose3d X_WL = X_WM * pose_in(link, kModelFrame);
    const auto& inertial = link.Inertial();
    result_.links.push_back(
        {.name = scope + link.Name(),
         .p_WL = vector_of(X_WL.Pos()),
         .R_WL = rotation_of(X_WL),
         .mass = inertial.MassMatrix().Mass(),
         .p_LCm = vector_of(inertial.Pose().Pos()),
         .inertia_LCm = matrix_of(inertial.Moi()),  // in the link's axes
         .is_fixed = is_fixed});
    if (!is_fixed) tell_assumed(link, scope);
  }

  /// SDF has its defaults for what a link does not say.
  void tell_assumed(const sdf::Link& link, const std::string& scope) {
    const sdf::ElementPtr element = link.Element();
    const bool has_inertial = element->HasElement("inertial");
    const auto lacks = [&](const char* name) {
      return !has_inertial ||
             !element->GetElement("inertial")->HasElement(name);
    };
    for (const auto& [name, value] :
         {std::pair("mass", "1 kg"), std::pair("inertia", "1 kg m^2")}) {
      if (!lacks(name)) continue;
      result_.told.push_back(
          fmt::format("link {}: no <{}>; {} assumed, as SDF does",
                      scope + link.Name(), name, value));
    }
  }

  std::string link_name(const std::string& scope, const std::string& name) {
    return name == "world" ? std::string() : scope + name;
  }

  void add(const sdf::Joint& joint, const Pose3d& X_WM,
           const std::string& scope) {
    std::string parent, child;
    require(joint.ResolveParentLink(parent));
    require(joint.ResolveChildLink(child));
    const Pose3d X_WJ = X_WM * pose_in(joint, kModelFrame);
    multibody::Joint found{.name = scope + joint.Name(),
                           .type = word_of(joint.Type()),
                           .parent = link_name(scope, parent),
                           .child = link_name(scope, child),
                           .point = vector_of(X_WJ.Pos()),
                           .axes = {}};
    for (unsigned i = 0; i < 2; ++i) {
      const sdf::JointAxis* axis = joint.Axis(i);
      if (axis != nullptr) found.axes.push_back(axis_of(*axis, X_WM));
    }
    // As Gazebo takes it: rad/m, positive for a left-handed thread.
    if (joint.Type() == sdf::JointType::SCREW) {
      found.lead = -2.0 * std::numbers::pi / joint.ThreadPitch();
      result_.told.push_back(
          fmt::format("joint {}: thread_pitch {} read as rad/m, left-handed "
                      "where positive, as Gazebo does",
                      found.name, joint.ThreadPitch()));
    }
    result_.joints.push_back(std::move(found));
  }

  multibody::Axis axis_of(const sdf::JointAxis& axis,
                          const Pose3d& X_WM) const {
    constexpr double kNoLimit = 1e15;  // SDF's own is 1e16
    ignition::math::Vector3d direction;
    require(axis.ResolveXyz(direction, kModelFrame));
    multibody::Axis found;
    found.direction = vector_of(X_WM.Rot().RotateVector(direction));
    if (!(axis.Lower() <= -kNoLimit)) found.lower = axis.Lower();
    if (!(axis.Upper() >= kNoLimit)) found.upper = axis.Upper();
    found.stop_stiffness = axis.Stiffness();
    found.stop_damping = axis.Dissipation();
    found.damping = axis.Damping();
    found.friction = axis.Friction();
    found.spring_stiffness = axis.SpringStiffness();
    found.spring_reference = axis.SpringReference();
    return found;
  }

  const std::string& file_;
  multibody::Model result_;
};

}  // namespace

multibody::Model read_sdf(const std::string& xml, const std::string& file) {
  return Reader(file).read(xml);
}

}  // namespace clevis::importer
