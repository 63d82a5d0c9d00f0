#include "mechanism/constraints/closed_joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/constraints/assembly.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {

using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// A vector of a body in the world, as the user placed it.
Vector3d turned(const MechanismDefinition& definition, BodyIndex body,
                const Vector3d& v_L) {
  if (body == kGround) return v_L;
  return definition.bodies[static_cast<std::size_t>(body)].placement.R_WL * v_L;
}

Vector3d placed(const MechanismDefinition& definition, BodyIndex body,
                const Vector3d& p_L) {
  if (body == kGround) return p_L;
  return definition.bodies[static_cast<std::size_t>(body)].placement.p_WL +
         turned(definition, body, p_L);
}

/// "C by 5 mm, D by -1 mm": joints whose points lie apart along their axes as
/// the bodies are placed. Where bodies stand at one height these are the ones
/// to correct, not those at which a loop happens to stay open.
std::string apart_as_placed(const MechanismDefinition& definition,
                            double tolerance) {
  std::string text;
  for (const JointDefinition& joint : definition.joints) {
    if (traits(joint.type).in_plane != JointTraits::InPlane::kNormalAxis) {
      continue;
    }
    const Vector3d axis =
        turned(definition, joint.body_a, joint.frame_a.R_LJ.col(2));
    const double gap =
        axis.dot(placed(definition, joint.body_b, joint.frame_b.p_LJ) -
                 placed(definition, joint.body_a, joint.frame_a.p_LJ));
    if (std::abs(gap) <= tolerance) continue;
    text += fmt::format("{}{} by {:.6g} mm", text.empty() ? "" : ", ",
                        joint.name, 1e3 * gap);
  }
  return text;
}

/// Axes that were meant parallel, "" if there are none: of the joints that turn
/// about one axis alone the one most inclined to the first.
std::string inclined_axes(const MechanismDefinition& definition) {
  constexpr double kMeantParallel = 0.01;  // [rad]
  constexpr double kParallel = 1e-9;       // [rad], as in a plane of motion
  const JointDefinition *first = nullptr, *worst = nullptr;
  Vector3d axis;
  double largest = kParallel;
  for (const JointDefinition& joint : definition.joints) {
    if (traits(joint.type).in_plane != JointTraits::InPlane::kNormalAxis) {
      continue;
    }
    for (const auto& [body, frame] :
         {std::pair{joint.body_a, &joint.frame_a},
          std::pair{joint.body_b, &joint.frame_b}}) {
      const Vector3d z = turned(definition, body, frame->R_LJ.col(2));
      if (first == nullptr) {
        first = &joint;
        axis = z;
      }
      const double angle = std::asin(std::min(1.0, axis.cross(z).norm()));
      if (angle > kMeantParallel) return "";
      if (angle <= largest) continue;
      largest = angle;
      worst = &joint;
    }
  }
  if (worst == nullptr) return "";
  return fmt::format(
      "The axes of {} and {} differ by {:.3g} deg: if they are meant parallel, "
      "give them, and the placements of their bodies, the same digits. ",
      first->name, worst->name, largest * 180.0 / std::numbers::pi);
}

/// The body whose placement is far from all of its joints, as of m that were
/// meant as mm; "" if there is none.
std::string misplaced_body(const MechanismDefinition& definition) {
  constexpr double kFar = 5.0;  // times the size of the bodies
  std::vector<double> nearest(definition.bodies.size(), HUGE_VAL);  // [m]
  double size = 0.0;
  for (const JointDefinition& joint : definition.joints) {
    const double gap = (placed(definition, joint.body_b, joint.frame_b.p_LJ) -
                        placed(definition, joint.body_a, joint.frame_a.p_LJ))
                           .norm();
    for (const auto& [body, frame] :
         {std::pair{joint.body_a, &joint.frame_a},
          std::pair{joint.body_b, &joint.frame_b}}) {
      if (body == kGround) continue;
      size = std::max(size, frame->p_LJ.norm());
      double& least = nearest[static_cast<std::size_t>(body)];
      least = std::min(least, gap);
    }
  }
  const BodyDefinition* worst = nullptr;
  double farthest = kFar * size;
  for (std::size_t b = 0; b < nearest.size(); ++b) {
    if (!std::isfinite(nearest[b]) || nearest[b] <= farthest) continue;
    farthest = nearest[b];
    worst = &definition.bodies[b];
  }
  if (worst == nullptr || size == 0.0) return "";
  return fmt::format(
      "The placement of body {} is {:.4g} mm off all of its joints: see its "
      "unit first. ",
      worst->name, 1e3 * farthest);
}

}  // namespace

void refuse_open(const MechanismDefinition& definition, const OpenJoints& open,
                 std::string_view closing) {
  std::string remedy;
  if (open.along_axes.empty()) {
    remedy = misplaced_body(definition) + inclined_axes(definition) +
             "Correct the lengths in `at`, the start of the drive or the "
             "placement of the bodies.";
  } else {
    const std::string apart = apart_as_placed(definition, open.tolerance);
    remedy = fmt::format(
        "What turns about one pin must meet at one height; as the bodies are "
        "placed, points lie apart along their axes at {}. Change that "
        "component in `at` of one body. Parts side by side on a pin are "
        "modelled as if in one plane, or one of the loop's joints as "
        "`cylindrical`, which leaves the height free.",
        apart.empty() ? open.along_axes.front() : apart);
  }
  throw Error("K001", "mechanism",
              fmt::format("no position near the given placement closes {}; "
                          "open: {}; {:.2g} mm are allowed",
                          closing, open.text, 1e3 * open.tolerance),
              remedy);
}

Configuration closed_joints(const MechanismDefinition& definition,
                            const SolvingFrame& frame, double tolerance) {
  const ConstraintSystem joints(
      frame, {}, frame.planar ? Motions::kInPlane : Motions::kSpatial,
      ConstraintSystem::Drives::kNone);
  const Assembled assembled = assemble(joints, frame.placement, VectorXd(),
                                       tolerance, frame.rank_threshold());
  if (!assembled.closed) {
    refuse_open(definition,
                open_joints(definition, joints, assembled.residual, tolerance),
                "all joints");
  }
  if (frame.planar) {  // across the plane only the loops can stay open
    const ConstraintSystem across(frame, {}, Motions::kOutOfPlane,
                                  ConstraintSystem::Drives::kNone);
    const VectorXd gaps =
        across.residual(across.place(assembled.x), VectorXd());
    if (largest_gap(gaps) > tolerance) {
      refuse_open(definition, open_joints(definition, across, gaps, tolerance),
                  "all joints along the normal of the plane of motion");
    }
  }
  return assembled.x;
}

}  // namespace clevis::mechanism
