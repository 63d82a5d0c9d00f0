#pragma once

#include <vector>

#include <Eigen/Core>

#include "cad/cylinders.h"
#include "cad/face.h"

namespace clevis::cad {

/// A bore that a pin may fill: pieces of one diameter on one axis, each all the
/// way round.
struct PinBore {
  std::vector<Cylinder> pieces;  ///< both ears of a fork are two
  Eigen::Vector3d middle =
      Eigen::Vector3d::Zero();  ///< half-way between the outer ends [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector
  double diameter{};                                ///< [m]
  double length{};                                  ///< of all pieces [m]

  double bearing_area() const { return diameter * length; }  ///< [m²]
  std::vector<int> faces() const;                            ///< numbers
};

/// The bores of a solid, the widest first; equal ones by x, then y, then z. Of
/// several diameters on one axis (a counterbore) the one of the largest bearing
/// area stands for all.
std::vector<PinBore> pin_bores(const Solid& solid);

}  // namespace clevis::cad
