#include "mechanism/constraints/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {
namespace {

using InPlane = JointTraits::InPlane;

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kParallel = 1e-9;  // [rad]

Matrix3d rotation(const MechanismDefinition& definition, BodyIndex body) {
  return body == kGround
             ? Matrix3d(Matrix3d::Identity())
             : definition.bodies[static_cast<std::size_t>(body)].placement.R_WL;
}

Matrix3d axes(const MechanismDefinition& definition, BodyIndex body,
              const JointFrame& frame) {
  return rotation(definition, body) * frame.R_LJ;
}

/// Turns about z only, or not at all about other axes.
bool has_normal_axis(JointType type) {
  return traits(type).in_plane == InPlane::kNormalAxis;
}

/// Normal that the joints suggest; world z where they leave it open.
Vector3d suggested_normal(const MechanismDefinition& definition) {
  Vector3d slide = Vector3d::Zero();
  for (const JointDefinition& joint : definition.joints) {
    const Vector3d z = axes(definition, joint.body_a, joint.frame_a).col(2);
    if (has_normal_axis(joint.type)) return z;
    if (traits(joint.type).in_plane != InPlane::kAxisWithin) continue;
    const Vector3d normal = slide.cross(z);
    if (normal.norm() > 1e-3) return normal.normalized();
    slide = z;
  }
  // parallel slides only, or none: any plane along them, nearest to world z
  const Vector3d across =
      Vector3d::UnitZ() - slide.dot(Vector3d::UnitZ()) * slide;
  return across.norm() > 1e-3 ? Vector3d(across.normalized())
                              : Vector3d(slide.unitOrthogonal());
}

/// The axes of a joint whose own may lie askew to the plane, one along the
/// normal: of a slide x, of a weld or a ball z and x as near to an old axis as
/// the plane lets it be.
Matrix3d aligned_axes(const JointDefinition& joint, const Matrix3d& old,
                      const Vector3d& normal) {
  Matrix3d turned;
  if (traits(joint.type).in_plane == InPlane::kAxisWithin) {
    turned.col(0) = normal;
    turned.col(2) = old.col(2);
    turned.col(1) = turned.col(2).cross(turned.col(0)).normalized();
    turned.col(0) = turned.col(1).cross(turned.col(2));
    return turned;
  }
  const Matrix3d within = old - normal * (normal.transpose() * old);
  Eigen::Index most = 0;
  within.colwise().norm().maxCoeff(&most);
  turned.col(0) = within.col(most).normalized();
  turned.col(1) = normal.cross(turned.col(0));
  turned.col(2) = normal;
  return turned;
}

/// Whether a joint's compliance couples the axes that it has in the plane.
bool couples_axes(const JointDefinition& joint, const Matrix3d& old,
                  const Vector3d& normal) {
  if (!joint.compliance || has_normal_axis(joint.type)) return false;
  const Matrix3d turn = old.transpose() * aligned_axes(joint, old, normal);
  return std::ranges::any_of(
      std::array{joint.compliance->force, joint.compliance->moment},
      [&turn](const Vector3d& along) {
        const Matrix3d given = along.asDiagonal();
        Matrix3d here = turn.transpose() * given * turn;
        here.diagonal().setZero();
        return here.norm() > kParallel * along.norm();
      });
}

/// First joint that moves its bodies out of the plane, or null.
const JointDefinition* find_spatial_joint(const MechanismDefinition& definition,
                                          const Vector3d& normal) {
  for (const JointDefinition& joint : definition.joints) {
    const Matrix3d axes_a = axes(definition, joint.body_a, joint.frame_a);
    const Matrix3d axes_b = axes(definition, joint.body_b, joint.frame_b);
    const Vector3d z_a = axes_a.col(2), z_b = axes_b.col(2);
    const InPlane in_plane = traits(joint.type).in_plane;
    if (in_plane == InPlane::kNoAxis) continue;
    if (in_plane == InPlane::kNever) return &joint;
    const bool fits =
        has_normal_axis(joint.type)
            ? z_a.cross(normal).norm() < kParallel &&
                  (z_a - z_b).norm() < kParallel
            // the same turn about the normal on both bodies
            : (axes_a.transpose() * normal - axes_b.transpose() * normal)
                          .norm() < kParallel &&
                  (in_plane == InPlane::kAnyAxis ||
                   std::abs(z_a.dot(normal)) < kParallel);
    if (!fits) return &joint;
  }
  return nullptr;
}

/// First joint whose compliance has axes askew to the plane, or null.
const JointDefinition* find_oblique_compliance(
    const MechanismDefinition& definition, const Vector3d& normal) {
  const auto found = std::ranges::find_if(
      definition.joints, [&](const JointDefinition& joint) {
        return couples_axes(
            joint, axes(definition, joint.body_a, joint.frame_a), normal);
      });
  return found == definition.joints.end() ? nullptr : &*found;
}

/// Whether joints keep every body in the plane that is ground's.
bool all_hang_on_ground(const MechanismDefinition& definition) {
  std::vector<bool> held(definition.bodies.size() + 1, false);
  held[0] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const JointDefinition& joint : definition.joints) {
      const auto a = static_cast<std::size_t>(joint.body_a + 1);
      const auto b = static_cast<std::size_t>(joint.body_b + 1);
      if (held[a] == held[b]) continue;
      held[a] = held[b] = grown = true;
    }
  }
  return std::ranges::find(held, false) == held.end();
}

/// Whether friction in a slide follows its force and loads act across the
/// plane: these press on the slide, but are no part of the motion.
bool presses_slides_across(const MechanismDefinition& definition,
                           const Vector3d& normal) {
  const auto follows = [&definition](const ForceElement& element) {
    return properties(element).follows_reaction &&
           !is_angle(element, definition.joints);
  };
  if (std::ranges::none_of(definition.elements, follows)) return false;
  const auto across = [&normal](const Vector3d& v) {
    return std::abs(v.dot(normal)) > kParallel * v.norm();
  };
  return across(definition.gravity_W) ||
         std::ranges::any_of(definition.elements, [&](const auto& element) {
           return across(properties(element).fixed_force_W);
         });
}

}  // namespace

std::optional<Matrix3d> find_plane(const MechanismDefinition& definition) {
  if (definition.dimension == SpaceDimension::kSpatial) return std::nullopt;
  if (definition.dimension == SpaceDimension::kAuto &&
      (!all_hang_on_ground(definition) ||
       !std::ranges::all_of(definition.joints, [](const auto& joint) {
         return traits(joint.type).implies_plane;
       }))) {
    return std::nullopt;
  }
  Vector3d normal = suggested_normal(definition);
  // of both normals the one that looks the user's way
  if (normal.z() < -kParallel) normal = -normal;
  if (definition.dimension == SpaceDimension::kAuto &&
      presses_slides_across(definition, normal)) {
    return std::nullopt;
  }
  const JointDefinition* spatial = find_spatial_joint(definition, normal);
  if (spatial != nullptr) {
    if (definition.dimension == SpaceDimension::kAuto) return std::nullopt;
    throw Error("S010", spatial->place,
                fmt::format("dimension is \"planar\", but joint {} moves its "
                            "bodies out of the plane with normal ({:.4g}, "
                            "{:.4g}, {:.4g})",
                            spatial->name, normal.x(), normal.y(), normal.z()),
                "Correct the joint's axis, or set dimension to \"spatial\" or "
                "\"auto\".");
  }
  if (const auto* oblique = find_oblique_compliance(definition, normal)) {
    if (definition.dimension == SpaceDimension::kAuto) return std::nullopt;
    throw Error("S010", oblique->place,
                fmt::format("dimension is \"planar\", but the axes of joint "
                            "{}'s compliance are askew to the plane",
                            oblique->name),
                "Give it one axis along the plane's normal, or set dimension "
                "to \"spatial\" or \"auto\".");
  }
  if (normal.isApprox(Vector3d::UnitZ(), kParallel)) {
    return Matrix3d(Matrix3d::Identity());
  }
  Matrix3d R_WP;
  R_WP.col(0) = normal.unitOrthogonal();
  R_WP.col(1) = normal.cross(R_WP.col(0));
  R_WP.col(2) = normal;
  return R_WP;
}

void align_joint_frames(MechanismDefinition& definition,
                        const Vector3d& normal_W) {
  for (JointDefinition& joint : definition.joints) {
    if (has_normal_axis(joint.type)) continue;
    const Matrix3d old = axes(definition, joint.body_a, joint.frame_a);
    const Matrix3d turn = old.transpose() * aligned_axes(joint, old, normal_W);
    joint.frame_a.R_LJ *= turn;
    joint.frame_b.R_LJ *= turn;
    if (!joint.compliance) continue;
    for (Vector3d* c : {&joint.compliance->force, &joint.compliance->moment}) {
      const Matrix3d old_axes = c->asDiagonal();
      *c = (turn.transpose() * old_axes * turn).diagonal();
    }
  }
}

}  // namespace clevis::mechanism
