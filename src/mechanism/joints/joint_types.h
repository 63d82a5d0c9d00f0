#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "mechanism/joints/joint_definition.h"

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
  /// Of a universal joint; a placed joint counts the turns of its first alone.
  bool is_second_angle() const { return kind == Kind::kUniversal && axis == 1; }
};

/// A motion that a joint leaves free, and that a drive may prescribe.
struct JointCoordinate {
  std::string_view name;
  JointRow row;
};

/// Traits of a joint type, for everybody who asks: one row of the table in
/// joint_types.cc. A new type needs that row and, in joint_motion.cc, the
/// coordinates of its motion; one that holds a new kind of row needs that kind
/// in PlacedJoint.
struct JointTraits {
  /// Key `axis` of the scene: z of the joint's frame.
  enum class Axis { kNone, kOptional, kNeeded };
  /// Data of its own that the type needs.
  enum class Parameter { kNone, kLead, kLength };
  /// How the frame stands where bodies move in a plane.
  enum class InPlane {
    kNever,       ///< not in planar mechanisms
    kNormalAxis,  ///< z along the normal
    kAxisWithin,  ///< z in the plane
    kAnyAxis,
    kNoAxis  ///< it holds nothing across the plane
  };

  JointType type{};
  std::string_view name;           ///< "revolute", as the scene file calls it
  std::span<const JointRow> rows;  ///< held motions, those in the plane first
  std::size_t rows_in_plane{};
  std::span<const JointCoordinate> coordinates;  ///< the usual one first
  Axis axis = Axis::kNeeded;
  bool needs_normal = false;  ///< x of b is a second axis
  Parameter parameter = Parameter::kNone;
  InPlane in_plane{};
  bool implies_plane = false;  ///< planar without the user's word for it
  /// Straight lines along which the bodies slide on one another: along z, or
  /// along x and y.
  int slide_directions = 0;
  bool turns_about_z = true;       ///< PlacedJoint::turned() tells an angle
  bool counts_turns = false;       ///< beyond one turn
  bool keeps_orientation = false;  ///< of b against a
  bool merges_links = false;       ///< both bodies are one link
  bool is_lower_pair = false;      ///< of the plane: a hinge or a slide
  bool takes_bearing = false;
  bool takes_reaction_friction = false;  ///< proportional to its own reaction
  bool needs_cylinder = false;           ///< it turns in its seat
  bool may_stand_for_hinge = false;      ///< if its pin does not slide

  bool slides() const { return slide_directions > 0; }
  /// Column of the frame along which it slides. @pre slides().
  int slide_axis() const { return slide_directions == 2 ? 0 : 2; }
  /// Exactly one coordinate, and that an angle.
  bool is_hinge() const {
    return coordinates.size() == 1 && coordinates[0].row.is_angle();
  }
};

const JointTraits& traits(JointType type);

/// All types, in the order of the enumeration.
std::span<const JointTraits> all_joint_types();

/// Rows that a joint type holds, within the given motions. In the plane, frames
/// have z normal to it, of slides x.
std::span<const JointRow> constrained_rows(JointType type, Motions motions);

/// Coordinates of a joint type, the first is the usual one; welds and
/// distances have none.
std::span<const JointCoordinate> coordinates(JointType type);

/// @pre the type has that coordinate.
JointRow coordinate_row(JointType type, int coordinate = 0);

/// "revolute", as the scene file calls it.
std::string_view name_of(JointType type);

}  // namespace clevis::mechanism
