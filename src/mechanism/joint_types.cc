#include "mechanism/joint_types.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace clevis::mechanism {
namespace {

constexpr auto kT = JointRow::Kind::kTranslation;
constexpr auto kR = JointRow::Kind::kRotation;
constexpr auto kU = JointRow::Kind::kUniversal;
constexpr auto kC = JointRow::Kind::kCardan;

/// Rows of a type, those in the plane first.
struct TypeRows {
  std::span<const JointRow> all;
  std::size_t in_plane;
};

TypeRows type_rows(JointType type) {
  static constexpr std::array kRevolute{JointRow{kT, 0}, JointRow{kT, 1},
                                        JointRow{kT, 2}, JointRow{kR, 0},
                                        JointRow{kR, 1}};
  static constexpr std::array kPrismatic{JointRow{kT, 1}, JointRow{kR, 0},
                                         JointRow{kT, 0}, JointRow{kR, 1},
                                         JointRow{kR, 2}};
  static constexpr std::array kWeld{JointRow{kT, 0}, JointRow{kT, 1},
                                    JointRow{kR, 2}, JointRow{kT, 2},
                                    JointRow{kR, 0}, JointRow{kR, 1}};
  static constexpr std::array kCylindrical{JointRow{kT, 0}, JointRow{kT, 1},
                                           JointRow{kR, 0}, JointRow{kR, 1}};
  static constexpr std::array kUniversal{JointRow{kT, 0}, JointRow{kT, 1},
                                         JointRow{kT, 2}, JointRow{kU, 2}};
  static constexpr std::array kSpherical{JointRow{kT, 0}, JointRow{kT, 1},
                                         JointRow{kT, 2}};
  static constexpr std::array kPlanar{JointRow{kT, 2}, JointRow{kR, 0},
                                      JointRow{kR, 1}};
  static constexpr std::array kScrew{JointRow{kT, 0}, JointRow{kT, 1},
                                     JointRow{kR, 0}, JointRow{kR, 1},
                                     JointRow{JointRow::Kind::kScrew, 2}};
  static constexpr std::array kDistance{JointRow{JointRow::Kind::kDistance, 0}};
  switch (type) {
    case JointType::kRevolute:
      return {kRevolute, 2};
    case JointType::kPrismatic:
      return {kPrismatic, 2};
    case JointType::kCylindrical:
      return {kCylindrical, 2};
    case JointType::kUniversal:
      return {kUniversal, 0};  // not in planar mechanisms
    case JointType::kSpherical:
      return {kSpherical, 2};
    case JointType::kPlanar:
      return {kPlanar, 0};
    case JointType::kScrew:
      return {kScrew, 0};  // not in planar mechanisms
    case JointType::kDistance:
      return {kDistance, 1};
    case JointType::kWeld:
      break;
  }
  return {kWeld, 3};
}

}  // namespace

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
  const TypeRows rows = type_rows(type);
  switch (motions) {
    case Motions::kInPlane:
      return rows.all.first(rows.in_plane);
    case Motions::kOutOfPlane:
      return rows.all.subspan(rows.in_plane);
    case Motions::kSpatial:
      break;
  }
  return rows.all;
}

std::span<const JointCoordinate> coordinates(JointType type) {
  using Coordinate = JointCoordinate;
  static constexpr std::array kAngle{Coordinate{"angle", {kR, 2}}};
  static constexpr std::array kSlide{Coordinate{"distance", {kT, 2}}};
  static constexpr std::array kBoth{kAngle[0], kSlide[0]};
  static constexpr std::array kUniversal{Coordinate{"angle_1", {kU, 0}},
                                         Coordinate{"angle_2", {kU, 1}}};
  static constexpr std::array kSpherical{Coordinate{"angle_1", {kC, 0}},
                                         Coordinate{"angle_2", {kC, 1}},
                                         Coordinate{"angle_3", {kC, 2}}};
  static constexpr std::array kPlanar{Coordinate{"x", {kT, 0}},
                                      Coordinate{"y", {kT, 1}}, kAngle[0]};
  switch (type) {
    case JointType::kRevolute:
      return kAngle;
    case JointType::kPrismatic:
      return kSlide;
    case JointType::kCylindrical:
    case JointType::kScrew:
      return kBoth;
    case JointType::kUniversal:
      return kUniversal;
    case JointType::kSpherical:
      return kSpherical;
    case JointType::kPlanar:
      return kPlanar;
    case JointType::kWeld:
    case JointType::kDistance:
      break;
  }
  return {};
}

JointRow coordinate_row(JointType type, int coordinate) {
  const auto all = coordinates(type);
  assert(static_cast<std::size_t>(coordinate) < all.size());
  return all[static_cast<std::size_t>(coordinate)].row;
}

bool turns_about_z(JointType type) {
  return type != JointType::kPrismatic && type != JointType::kWeld &&
         type != JointType::kDistance;
}

std::string_view name_of(JointType type) {
  constexpr std::array<std::string_view, 9> kNames{
      "revolute",  "prismatic", "weld",  "cylindrical", "universal",
      "spherical", "planar",    "screw", "distance"};
  return kNames[static_cast<std::size_t>(type)];
}

bool drives_angle(const MechanismDefinition& definition,
                  const DriveDefinition& drive) {
  const auto joint = static_cast<std::size_t>(drive.joint);
  return coordinate_row(definition.joints[joint].type, drive.coordinate)
      .is_angle();
}

std::string drive_name(const MechanismDefinition& definition,
                       const DriveDefinition& drive) {
  const JointDefinition& joint =
      definition.joints[static_cast<std::size_t>(drive.joint)];
  if (drive.coordinate == 0) return joint.name;
  const auto k = static_cast<std::size_t>(drive.coordinate);
  return joint.name + "." + std::string(coordinates(joint.type)[k].name);
}

}  // namespace clevis::mechanism
