#pragma once

#include <optional>

#include <Eigen/Core>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Rotation matrix R_WP whose z is the normal of the plane in which all bodies
/// of the mechanism move, or nothing if the joints (in the reference placement)
/// allow no such plane.
///
/// Planar: axes of revolutes (planar, cylindrical, spherical joints) parallel
/// to z and of the same sense on both bodies, slides normal to it, all to
/// 1e-9. Unless the user says "planar", only revolutes, slides, welds and
/// planar joints count as such: the others leave bodies loose across it.
/// Nor may a compliance have axes askew to the plane, for it would couple what
/// is solved in it with what is solved across.
/// @throws Error S010 if `definition.dimension` says planar and it is not.
std::optional<Eigen::Matrix3d> find_plane(
    const MechanismDefinition& definition);

/// Turns the frames of a planar mechanism's joints, alike on both bodies, so
/// that the plane's normal is z of revolutes and welds and x of prismatic
/// joints. The joints remain the same.
/// @pre no compliance couples the new axes, as find_plane() sees to.
/// @param normal_W  unit normal.
void align_joint_frames(MechanismDefinition& definition,
                        const Eigen::Vector3d& normal_W);

}  // namespace clevis::mechanism
