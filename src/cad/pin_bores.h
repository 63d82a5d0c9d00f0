#pragma once

#include <vector>

#include <Eigen/Core>

#include "cad/cylinders.h"
#include "cad/face.h"

namespace clevis::cad {

/// A bore: pieces of one diameter on one axis.
struct PinBore {
  std::vector<Cylinder> pieces;  ///< both ears of a fork are two
  Eigen::Vector3d middle =
      Eigen::Vector3d::Zero();  ///< half-way between the outer ends [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector
  double diameter{};                                ///< [m]
  double length{};                                  ///< of all pieces [m]
  double extent{};       ///< between the outer ends [m]
  part::Wall wall = {};  ///< of all pieces

  double bearing_area() const { return diameter * length; }  ///< [m²]
  /// Of the wall that the pieces would have all the way round [1].
  double share() const;
  bool is_whole() const;  ///< as loads of pins see it
  /// Whether a pin may fill it: it closes about that but for a keyway or a
  /// slot, and is no tips of teeth.
  bool takes_pin() const;
  std::vector<int> faces() const;  ///< numbers
};

/// Those bores of a solid that a pin may fill, the widest first; equal ones by
/// x, then y, then z. Of several diameters on one axis (a counterbore) the one
/// of the largest bearing area stands for all.
std::vector<PinBore> pin_bores(const Solid& solid);

/// Bores that no pin may fill, the widest first: a keyway, a slot, a cross bore
/// or a sloped end takes too much of their walls. Concave fillets and ends of
/// slots are none.
std::vector<PinBore> open_bores(const Solid& solid);

}  // namespace clevis::cad
