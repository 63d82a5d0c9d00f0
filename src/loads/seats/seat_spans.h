#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/history/group_geometry.h"
#include "mechanism/definition/definition.h"
#include "part/part_definition.h"

namespace clevis::loads {

/// From and to along a line [m].
struct Interval {
  double low{}, high{};

  double length() const { return high - low; }
  double middle() const { return 0.5 * (low + high); }
};

/// Interval of p · direction over the points [m]. @param direction  unit
/// vector.
/// @pre there are points.
Interval extent(const Eigen::Matrix3Xd& points,
                const Eigen::Vector3d& direction);

/// Points that span a group, in L [m]; of a cylinder the ends of its axis.
Eigen::Matrix3Xd spanning_points(const GroupGeometry& group);

/// Known extent of a joint's contact on one of its bodies, in the joint's frame
/// J there.
struct SeatSpan {
  Eigen::Matrix3Xd points_J;  ///< of the body's own seat; none: not known [m]
  bool is_cylinder = false;
  /// Said by the part on the other body: what touches it, along z of J.
  std::optional<Interval> stated;
  std::optional<double> stated_width;  ///< likewise, about the origin [m]

  bool is_known() const { return points_J.cols() > 0; }
};

/// Per joint of the mechanism: on its bodies a and b.
using SeatSpans = std::vector<std::array<SeatSpan, 2>>;

/// Adds what a part says of its joints. Groups that its mesh lacks are left
/// out. A `length` not below that of the part's own group says nothing of the
/// counterpart.
void add_seat_spans(const mechanism::MechanismDefinition& definition,
                    mechanism::BodyIndex body, const part::PartDefinition& part,
                    const std::vector<GroupGeometry>& groups, SeatSpans& spans);

/// The slide's direction, a unit vector in L: z of frame J, of a planar joint
/// x.
Eigen::Vector3d slide_axis(mechanism::JointType type,
                           const mechanism::JointFrame& frame);

}  // namespace clevis::loads
