#include "loads/seats/seat_spans.h"

#include <algorithm>

#include "mechanism/joints/joint_types.h"

namespace clevis::loads {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using mechanism::JointType;

namespace {

/// How much shorter than the group a `length` must be to leave some of it out.
constexpr double kWhole = 1.0 - 1e-6;

void add_seat(const mechanism::JointDefinition& joint, std::size_t own,
              const part::Seat& seat, const GroupGeometry& group,
              std::array<SeatSpan, 2>& spans) {
  const mechanism::JointFrame& frame = own == 0 ? joint.frame_a : joint.frame_b;
  const Matrix3Xd points = spanning_points(group);
  spans[own].points_J =
      frame.R_LJ.transpose() * (points.colwise() - frame.p_LJ);
  spans[own].is_cylinder = group.is_cylinder;
  const auto& length = seat.slide.length;
  if (!length) return;
  const Interval all = extent(points, slide_axis(joint.type, frame));
  if (*length >= kWhole * all.length()) return;
  SeatSpan& other = spans[1 - own];
  other.stated = {seat.slide.offset - 0.5 * *length,
                  seat.slide.offset + 0.5 * *length};
  other.stated_width = seat.slide.width;
}

}  // namespace

Interval extent(const Matrix3Xd& points, const Vector3d& direction) {
  const Eigen::RowVectorXd along = direction.transpose() * points;
  return {along.minCoeff(), along.maxCoeff()};
}

Matrix3Xd spanning_points(const GroupGeometry& group) {
  if (!group.is_cylinder) return group.points;
  const part::Bore& c = group.cylinder;
  const Vector3d half = 0.5 * c.length * c.axis_L;
  Matrix3Xd ends(3, 2);
  ends << c.p_LC - half, c.p_LC + half;
  return ends;
}

void add_seat_spans(const mechanism::MechanismDefinition& definition,
                    mechanism::BodyIndex body, const part::PartDefinition& part,
                    const std::vector<GroupGeometry>& groups,
                    SeatSpans& spans) {
  spans.resize(definition.joints.size());
  for (const part::Seat& seat : part.seats) {
    const auto joint = std::ranges::find(definition.joints, seat.joint,
                                         &mechanism::JointDefinition::name);
    const auto group =
        std::ranges::find(groups, seat.group, &GroupGeometry::name);
    if (joint == definition.joints.end() || group == groups.end()) continue;
    if (!mechanism::traits(joint->type).slides() ||
        spanning_points(*group).cols() == 0)
      continue;
    const std::size_t own = joint->body_b == body ? 1 : 0;
    add_seat(
        *joint, own, seat, *group,
        spans[static_cast<std::size_t>(joint - definition.joints.begin())]);
  }
}

Vector3d slide_axis(JointType type, const mechanism::JointFrame& frame) {
  return frame.R_LJ.col(mechanism::traits(type).slide_axis());
}

}  // namespace clevis::loads
