#include "mechanism/joints/joint_types.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace clevis::mechanism {
namespace {

constexpr auto kT = JointRow::Kind::kTranslation;
constexpr auto kR = JointRow::Kind::kRotation;
constexpr auto kU = JointRow::Kind::kUniversal;
constexpr auto kC = JointRow::Kind::kCardan;

// Held motions, those in the plane first.
constexpr std::array kRevoluteRows{JointRow{kT, 0}, JointRow{kT, 1},
                                   JointRow{kT, 2}, JointRow{kR, 0},
                                   JointRow{kR, 1}};
constexpr std::array kPrismaticRows{JointRow{kT, 1}, JointRow{kR, 0},
                                    JointRow{kT, 0}, JointRow{kR, 1},
                                    JointRow{kR, 2}};
constexpr std::array kWeldRows{JointRow{kT, 0}, JointRow{kT, 1},
                               JointRow{kR, 2}, JointRow{kT, 2},
                               JointRow{kR, 0}, JointRow{kR, 1}};
constexpr std::array kCylindricalRows{JointRow{kT, 0}, JointRow{kT, 1},
                                      JointRow{kR, 0}, JointRow{kR, 1}};
constexpr std::array kUniversalRows{JointRow{kT, 0}, JointRow{kT, 1},
                                    JointRow{kT, 2}, JointRow{kU, 2}};
constexpr std::array kSphericalRows{JointRow{kT, 0}, JointRow{kT, 1},
                                    JointRow{kT, 2}};
constexpr std::array kPlanarRows{JointRow{kT, 2}, JointRow{kR, 0},
                                 JointRow{kR, 1}};
constexpr std::array kScrewRows{JointRow{kT, 0}, JointRow{kT, 1},
                                JointRow{kR, 0}, JointRow{kR, 1},
                                JointRow{JointRow::Kind::kScrew, 2}};
constexpr std::array kPointOnLineRows{JointRow{kT, 1}, JointRow{kT, 0}};
constexpr std::array kDistanceRows{JointRow{JointRow::Kind::kDistance, 0}};

using Coordinate = JointCoordinate;
constexpr std::array kAngle{Coordinate{"angle", {kR, 2}}};
constexpr std::array kSlide{Coordinate{"distance", {kT, 2}}};
constexpr std::array kAngleAndSlide{kAngle[0], kSlide[0]};
constexpr std::array kUniversalAngles{Coordinate{"angle_1", {kU, 0}},
                                      Coordinate{"angle_2", {kU, 1}}};
constexpr std::array kBallAngles{Coordinate{"angle_1", {kC, 0}},
                                 Coordinate{"angle_2", {kC, 1}},
                                 Coordinate{"angle_3", {kC, 2}}};
constexpr std::array kSlideAndBallAngles{kSlide[0], kBallAngles[0],
                                         kBallAngles[1], kBallAngles[2]};
constexpr std::array kPlaneCoordinates{Coordinate{"x", {kT, 0}},
                                       Coordinate{"y", {kT, 1}}, kAngle[0]};

using enum JointTraits::Axis;
using Parameter = JointTraits::Parameter;
using InPlane = JointTraits::InPlane;

constexpr std::array kTypes{
    JointTraits{.type = JointType::kRevolute,
                .name = "revolute",
                .rows = kRevoluteRows,
                .rows_in_plane = 2,
                .coordinates = kAngle,
                .in_plane = InPlane::kNormalAxis,
                .implies_plane = true,
                .is_lower_pair = true,
                .takes_bearing = true,
                .takes_reaction_friction = true,
                .needs_cylinder = true},
    JointTraits{.type = JointType::kPrismatic,
                .name = "prismatic",
                .rows = kPrismaticRows,
                .rows_in_plane = 2,
                .coordinates = kSlide,
                .in_plane = InPlane::kAxisWithin,
                .implies_plane = true,
                .slide_directions = 1,
                .turns_about_z = false,
                .keeps_orientation = true,
                .is_lower_pair = true,
                .takes_reaction_friction = true},
    JointTraits{.type = JointType::kWeld,
                .name = "weld",
                .rows = kWeldRows,
                .rows_in_plane = 3,
                .coordinates = {},
                .axis = kOptional,
                .in_plane = InPlane::kAnyAxis,
                .implies_plane = true,
                .turns_about_z = false,
                .keeps_orientation = true,
                .merges_links = true},
    JointTraits{.type = JointType::kCylindrical,
                .name = "cylindrical",
                .rows = kCylindricalRows,
                .rows_in_plane = 2,
                .coordinates = kAngleAndSlide,
                .in_plane = InPlane::kNormalAxis,
                .slide_directions = 1,
                .takes_bearing = true,
                .takes_reaction_friction = true,
                .needs_cylinder = true,
                .may_stand_for_hinge = true},
    JointTraits{.type = JointType::kUniversal,
                .name = "universal",
                .rows = kUniversalRows,
                .rows_in_plane = 0,
                .coordinates = kUniversalAngles,
                .needs_normal = true,
                .in_plane = InPlane::kNever},
    JointTraits{.type = JointType::kSpherical,
                .name = "spherical",
                .rows = kSphericalRows,
                .rows_in_plane = 2,
                .coordinates = kBallAngles,
                .axis = kOptional,
                .in_plane = InPlane::kNormalAxis},
    JointTraits{.type = JointType::kPlanar,
                .name = "planar",
                .rows = kPlanarRows,
                .rows_in_plane = 0,
                .coordinates = kPlaneCoordinates,
                .in_plane = InPlane::kNormalAxis,
                .implies_plane = true,
                .slide_directions = 2},
    JointTraits{.type = JointType::kScrew,
                .name = "screw",
                .rows = kScrewRows,
                .rows_in_plane = 0,
                .coordinates = kAngleAndSlide,
                .parameter = Parameter::kLead,
                .in_plane = InPlane::kNever,
                .slide_directions = 1,
                .counts_turns = true,
                .needs_cylinder = true},
    JointTraits{.type = JointType::kDistance,
                .name = "distance",
                .rows = kDistanceRows,
                .rows_in_plane = 1,
                .coordinates = {},
                .axis = kNone,
                .parameter = Parameter::kLength,
                .in_plane = InPlane::kNoAxis,
                .turns_about_z = false},
    JointTraits{.type = JointType::kPointOnLine,
                .name = "point_on_line",
                .rows = kPointOnLineRows,
                .rows_in_plane = 1,
                .coordinates = kSlideAndBallAngles,
                .in_plane = InPlane::kAxisWithin,
                .slide_directions = 1,
                .turns_about_z = false},
};

constexpr bool is_in_order() {
  for (std::size_t k = 0; k < kTypes.size(); ++k) {
    if (static_cast<std::size_t>(kTypes[k].type) != k) return false;
  }
  return static_cast<std::size_t>(JointType::kPointOnLine) + 1 == kTypes.size();
}
static_assert(is_in_order(), "a row for each JointType, in its order");

}  // namespace

const JointTraits& traits(JointType type) {
  return kTypes[static_cast<std::size_t>(type)];
}

std::span<const JointTraits> all_joint_types() {
  return kTypes;
}

std::span<const int> twist_components(Motions motions) {
  static constexpr std::array kAll{0, 1, 2, 3, 4, 5};
  static constexpr std::array kIn{0, 1, 5}, kOut{2, 3, 4};
  switch (motions) {
    case Motions::kInPlane:
      return kIn;
    case Motions::kOutOfPlane:
      return kOut;
    case Motions::kSpatial:
      break;
  }
  return kAll;
}

std::span<const JointRow> constrained_rows(JointType type, Motions motions) {
  const JointTraits& joint = traits(type);
  switch (motions) {
    case Motions::kInPlane:
      return joint.rows.first(joint.rows_in_plane);
    case Motions::kOutOfPlane:
      return joint.rows.subspan(joint.rows_in_plane);
    case Motions::kSpatial:
      break;
  }
  return joint.rows;
}

std::span<const JointCoordinate> coordinates(JointType type) {
  return traits(type).coordinates;
}

JointRow coordinate_row(JointType type, int coordinate) {
  const auto all = coordinates(type);
  assert(static_cast<std::size_t>(coordinate) < all.size());
  return all[static_cast<std::size_t>(coordinate)].row;
}

std::string_view name_of(JointType type) {
  return traits(type).name;
}

}  // namespace clevis::mechanism
