#include "mechanism/constraints/closed_joints.h"

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/constraints/assembly.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

void refuse_open(const std::string& open, std::string_view closing) {
  throw Error("K001", "mechanism",
              fmt::format("no position near the given placement closes {}; "
                          "open: {}",
                          closing, open),
              "Correct the lengths in `at`, the start of the drive or the "
              "placement of the bodies.");
}

Configuration closed_joints(const MechanismDefinition& definition,
                            const SolvingFrame& frame, double tolerance) {
  const ConstraintSystem joints(
      frame, {}, frame.planar ? Motions::kInPlane : Motions::kSpatial,
      ConstraintSystem::Drives::kNone);
  const Assembled assembled = assemble(joints, frame.placement, VectorXd(),
                                       tolerance, frame.rank_threshold());
  if (!assembled.closed) {
    refuse_open(open_joints(definition, joints, assembled.residual, tolerance),
                "all joints");
  }
  if (frame.planar) {  // across the plane only the loops can stay open
    const ConstraintSystem across(frame, {}, Motions::kOutOfPlane,
                                  ConstraintSystem::Drives::kNone);
    const VectorXd gaps =
        across.residual(across.place(assembled.x), VectorXd());
    if (largest_gap(gaps) > tolerance) {
      refuse_open(open_joints(definition, across, gaps, tolerance),
                  "all joints along the normal of the plane of motion");
    }
  }
  return assembled.x;
}

}  // namespace clevis::mechanism
