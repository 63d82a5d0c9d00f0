#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/seats/seat_context.h"

namespace clevis::loads {

/// Refuses cylinders that do not lie on the axes of their joints, or whose
/// joint lies beyond their ends though it does not slide; the remedy says
/// what would make all of the part's coincide: another unit, a mesh that is
/// shifted, turned or mirrored, other numbers in the scene. Joints that do not
/// slide may stand off by a thousandth of the diameter, as far as they find
/// their bores in a solid.
/// @throws Error L003.
void require_fit(const SeatContext& context,
                 const std::vector<JointSeat>& seats);

/// Refuses a cylinder that does not lie on the axis of a joint of the body.
/// @param joint  index. @throws Error L003.
void require_coaxial(const SeatContext& context, const part::Bore& cylinder,
                     int joint, const std::string& group,
                     const std::string& place);

/// From each seat's axis across to its joint, in L [m]; zero where they agree
/// to the digits that scenes and meshes have, and of seats that are no
/// cylinders.
std::vector<Eigen::Vector3d> axis_offsets(const SeatContext& context,
                                          const std::vector<JointSeat>& seats);

/// A line for each joint that is off its cylinder's axis: by how much, and the
/// place on the axis.
std::vector<std::string> off_axis_notes(const SeatContext& context,
                                        const std::vector<JointSeat>& seats);

/// Whether a force that meets a bore's axis so far from the middle of its
/// length [m] is told: beyond 2 % of that length.
bool is_off_middle(double along, const part::Bore& bore);

/// A line for each joint that does not slide and stands more than 2 % of its
/// cylinder's length away from the middle: its force bends the part across.
std::vector<std::string> off_middle_notes(const SeatContext& context,
                                          const std::vector<JointSeat>& seats);

}  // namespace clevis::loads
