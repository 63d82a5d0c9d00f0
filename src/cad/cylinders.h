#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cad/face.h"
#include "part/bore.h"

namespace clevis::cad {

/// Faces of a solid that lie on one circular cylinder and follow one another
/// without a gap along its axis: the two halves of a bore are one.
struct Cylinder {
  std::vector<int> faces;  ///< numbers
  Eigen::Vector3d point;   ///< half-way along the axis [m]
  Eigen::Vector3d axis;    ///< unit vector
  double radius{};         ///< [m]
  double length{};         ///< along the axis [m]
  double angle{};          ///< that its faces turn about the axis [rad]
  part::Wall wall = {};    ///< that its faces are
  bool hollow{};           ///< a bore rather than a shaft

  bool is_round() const;  ///< all the way about the axis, or nearly so
  /// But for less than a quarter of a turn, as wide as keyways are: ends of
  /// slots and fillets have a half.
  bool closes_about_pin() const;
};

/// All cylinders of a solid.
std::vector<Cylinder> cylinders_of(const Solid& solid);

/// Directions that differ by less are one [rad].
inline constexpr double kSameDirection = 1e-3;

/// Whether unit vectors lie on one line, whatever their senses.
bool are_parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Whether both have one axis, to a thousandth of the radius over the length.
bool are_coaxial(const Cylinder& cylinder, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& axis);

/// Pieces of one diameter on one axis together, whatever lies between them:
/// both ears of a fork.
std::vector<std::vector<Cylinder>> by_axis(
    const std::vector<Cylinder>& cylinders);

/// "bore, diameter 16 mm, 9 mm long, middle (40, 0, -13.5) mm, face 16".
std::string text_of(const Cylinder& cylinder);

/// The first dozen of some for messages, "; " between; "none" of none.
std::string list_of(const std::vector<Cylinder>& cylinders);

}  // namespace clevis::cad
