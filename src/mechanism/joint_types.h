#pragma once

#include <span>
#include <string_view>

#include "mechanism/definition.h"

namespace clevis::mechanism {

/// Which motions of the bodies a system of equations is about. A planar
/// mechanism moves in its plane only, but its parts also carry what acts
/// across it.
enum class Motions { kSpatial, kInPlane, kOutOfPlane };

/// Indices into a twist (v, ω) that these motions use; the plane's normal is z.
std::span<const int> twist_components(Motions motions);

/// One constrained (or measured) motion of frame J on b against frame J on a.
struct JointRow {
  enum class Kind {
    kTranslation,  ///< along an axis of J on a
    kRotation,     ///< about an axis of J on a
    kUniversal,    ///< about z of a (0), x of b (1), their common normal (2)
    kCardan,       ///< angles about z of a (0), turned x (1), y of b (2)
    kScrew,        ///< slide along z less lead times turns
    kDistance      ///< between the origins, less the length
  } kind{};
  int axis{};  ///< 0, 1, 2: x, y, z of frame J on body a, or as above

  bool is_angle() const {
    return kind == Kind::kRotation || kind == Kind::kUniversal ||
           kind == Kind::kCardan;
  }
};

/// What a joint type holds, within the given motions. In the plane, frames
/// have z normal to it, of prismatic joints x.
/// This table, coordinates() and PlacedJoint are all that a new joint type
/// needs.
std::span<const JointRow> constrained_rows(JointType type, Motions motions);

/// A motion that a joint leaves free, and that a drive may prescribe.
struct JointCoordinate {
  std::string_view name;
  JointRow row;
};

/// Coordinates of a joint type, the first is the usual one; welds and
/// distances have none.
std::span<const JointCoordinate> coordinates(JointType type);

/// @pre the type has that coordinate.
JointRow coordinate_row(JointType type, int coordinate = 0);

/// Whether PlacedJoint::turned() tells an angle of it.
bool turns_about_z(JointType type);

/// "revolute", as the scene file calls it.
std::string_view name_of(JointType type);

/// Whether a drive prescribes an angle and takes a torque; else it is a
/// length and a force.
bool drives_angle(const MechanismDefinition& definition,
                  const DriveDefinition& drive);

/// "A", or "A.distance" if it is not the joint's first coordinate.
std::string drive_name(const MechanismDefinition& definition,
                       const DriveDefinition& drive);

}  // namespace clevis::mechanism
