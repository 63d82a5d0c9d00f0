#include "scene/motion/read_joints.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "mechanism/joints/joint_types.h"
#include "scene/motion/read_bodies.h"
#include "scene/motion/read_drives.h"
#include "scene/motion/read_joint_properties.h"
#include "scene/text/names.h"
#include "scene/text/suggestion.h"

namespace clevis::scene {
Eigen::Matrix3d joint_rotation(const Eigen::Vector3d& axis,
                               const Eigen::Vector3d& normal,
                               const Value& where) {
  constexpr double kParallel = 1e-3;  // radians
  const Eigen::Vector3d across = normal - normal.dot(axis) * axis;
  if (across.norm() < kParallel) {
    throw where.refusal("S006", "gives an axis parallel to the normal",
                        "Give normal a direction across the axis.");
  }
  Eigen::Matrix3d rotation;
  rotation.col(0) = across.normalized();
  rotation.col(1) = axis.cross(rotation.col(0));
  rotation.col(2) = axis;
  return rotation;
}

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanism::BodyDefinition;
using mechanism::BodyIndex;
using mechanism::JointDefinition;
using mechanism::JointTraits;
using mechanism::JointType;
using mechanism::kGround;
using mechanism::Pose;

/// A vector of a joint as its bodies a and b see it, each in its own frame.
using PerBody = std::array<Vector3d, 2>;

/// The two bodies of a joint with their reference placements.
struct JointBodies {
  std::array<std::string, 2> names;
  std::array<BodyIndex, 2> indices;
  std::array<Pose, 2> placements;
};

JointBodies read_between(const Value& value,
                         const std::vector<BodyDefinition>& bodies,
                         const Names& names) {
  JointBodies joint;
  const auto elements = value.elements(2);
  for (std::size_t i = 0; i < 2; ++i) {
    joint.indices[i] = find_body_or_ground(elements[i], names);
    joint.names[i] = elements[i].name();
    if (joint.indices[i] != kGround) {
      joint.placements[i] =
          bodies[static_cast<std::size_t>(joint.indices[i])].placement;
    }
  }
  if (joint.indices[0] == joint.indices[1]) {
    throw value.refusal("S010",
                        fmt::format("joins \"{}\" with itself", joint.names[0]),
                        "Name two different bodies, one may be \"ground\".");
  }
  return joint;
}

/// A table with one entry per body of the joint, e.g.
/// at = { AB = [...], ground = [...] }.
template <typename Read>
PerBody read_per_body(const Value& value, const JointBodies& joint, Read read) {
  PerBody vectors;
  std::array<bool, 2> is_given{};
  for (const auto& [name, entry] : value.entries()) {
    const std::size_t i = name == joint.names[0] ? 0 : 1;
    if (name != joint.names[i]) {
      throw entry.refusal("S007", "is no body of this joint",
                          suggestion(name, {joint.names[0], joint.names[1]}));
    }
    vectors[i] = read(entry);
    is_given[i] = true;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (is_given[i]) continue;
    throw value.refusal(
        "S003", fmt::format("lacks the body \"{}\"", joint.names[i]),
        "Give one entry for each body of the joint, in its own frame.");
  }
  return vectors;
}

/// A direction in W at the reference placement as the bodies see it.
PerBody seen_by_bodies(const Vector3d& direction_W, const JointBodies& joint) {
  return {joint.placements[0].R_WL.transpose() * direction_W,
          joint.placements[1].R_WL.transpose() * direction_W};
}

PerBody read_directions(const Value& value, const JointBodies& joint) {
  if (!value.is_table()) return seen_by_bodies(value.direction(), joint);
  return read_per_body(value, joint, [](const Value& entry) {
    return entry.direction();
  });
}

/// Origins of the joint frames: `at` in the bodies' frames or `point` in W.
PerBody read_origins(StrictTable& table, const JointBodies& joint) {
  const auto at = table.find("at");
  const auto point = table.find("point");
  if (at && point) {
    throw point->refusal("S010", "contradicts joint.at",
                         "Give either point (world) or at (per body).");
  }
  if (at) {
    return read_per_body(*at, joint, [](const Value& entry) {
      return entry.vector(Dimension::kLength);
    });
  }
  if (!point) {
    throw table.refusal("S003", "lacks the key \"at\" or \"point\"",
                        "Give point in the world, or at for each body.");
  }
  const Vector3d p_WJ = point->vector(Dimension::kLength);
  PerBody origins;
  for (std::size_t i = 0; i < 2; ++i) {
    const Pose& X_WL = joint.placements[i];
    origins[i] = X_WL.R_WL.transpose() * (p_WJ - X_WL.p_WL);
  }
  return origins;
}

/// World directions that serve as x of the joint frames if the user gives
/// none; the first that is not near the axis is taken. A slide keeps its
/// angle about the axis, so it starts with z, the normal of plane mechanisms.
PerBody default_normals(JointType type, const PerBody& axes,
                        const JointBodies& joint) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(),
                 z = Vector3d::UnitZ();
  constexpr double kNear = 0.9;  // cosine; one of three is always farther
  const auto candidates = mechanism::traits(type).keeps_orientation
                              ? std::array{z, x, y}
                              : std::array{x, y, z};
  for (const Vector3d& candidate : candidates) {
    const PerBody normals = seen_by_bodies(candidate, joint);
    if (std::abs(normals[0].dot(axes[0])) < kNear &&
        std::abs(normals[1].dot(axes[1])) < kNear) {
      return normals;
    }
  }
  return seen_by_bodies(candidates[0], joint);  // refused if parallel
}

/// x exactly along the normal, z along the axis as far as it is across.
Matrix3d normal_first(const Vector3d& axis, const Vector3d& normal,
                      const Value& where) {
  const Matrix3d rotation = joint_rotation(normal, axis, where);
  Matrix3d cyclic;
  cyclic << rotation.col(2), rotation.col(2).cross(-rotation.col(0)),
      rotation.col(0);
  return cyclic;
}

void read_rotations(StrictTable& table, const Value& name,
                    const JointBodies& between, JointDefinition& joint) {
  // Welds and ball joints have no axis of their own; z of the world serves.
  const JointTraits& type = mechanism::traits(joint.type);
  const auto axis = type.axis == JointTraits::Axis::kNeeded
                        ? std::optional(table["axis"])
                        : table.find("axis");
  const PerBody axes = axis ? read_directions(*axis, between)
                            : seen_by_bodies(Vector3d::UnitZ(), between);
  // The second axis of a universal joint is no matter of choice.
  const auto normal =
      type.needs_normal ? std::optional(table["normal"]) : table.find("normal");
  const PerBody normals = normal ? read_directions(*normal, between)
                                 : default_normals(joint.type, axes, between);
  const Value where = normal ? *normal : axis ? *axis : name;
  joint.frame_a.R_LJ = joint_rotation(axes[0], normals[0], where);
  joint.frame_b.R_LJ = type.needs_normal
                           ? normal_first(axes[1], normals[1], where)
                           : joint_rotation(axes[1], normals[1], where);
}

std::vector<std::pair<std::string_view, JointType>> joint_type_names() {
  std::vector<std::pair<std::string_view, JointType>> names;
  for (const JointTraits& type : mechanism::all_joint_types()) {
    names.emplace_back(type.name, type.type);
  }
  return names;
}

JointDefinition read_joint(StrictTable& table,
                           const std::vector<BodyDefinition>& bodies,
                           Names& names) {
  JointDefinition joint;
  const Value name = table["name"];
  joint.name = name.name();
  joint.place = table.place();
  names.joints.add(joint.name, name);
  joint.type = table["type"].choice(joint_type_names());
  const JointBodies between = read_between(table["between"], bodies, names);
  joint.body_a = between.indices[0];
  joint.body_b = between.indices[1];
  const PerBody origins = read_origins(table, between);
  joint.frame_a.p_LJ = origins[0];
  joint.frame_b.p_LJ = origins[1];
  if (mechanism::traits(joint.type).axis == JointTraits::Axis::kNone) {
    joint.frame_a.R_LJ = between.placements[0].R_WL.transpose();
    joint.frame_b.R_LJ = between.placements[1].R_WL.transpose();
  } else {
    read_rotations(table, name, between, joint);
  }
  read_joint_properties(table, bodies, joint);
  table.finish(fmt::format("with type = \"{}\"", name_of(joint.type)));
  return joint;
}

}  // namespace

std::vector<JointDefinition> read_joints(
    StrictTable& root, const std::vector<BodyDefinition>& bodies,
    Names& names) {
  std::vector<JointDefinition> joints;
  for (StrictTable& table : root.tables("joint")) {
    joints.push_back(read_joint(table, bodies, names));
  }
  return joints;
}

}  // namespace clevis::scene
