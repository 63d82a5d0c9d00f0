#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/buckling/energy_coordinates.h"
#include "elasticity/buckling/pin_hold.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/nodal_field.h"
#include "loads/history/load_history.h"
#include "part/material.h"
#include "part/part_definition.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// A way in which pins hold a free part as a whole (PinHold).
struct HoldingSeats {
  std::vector<std::string> groups;
  /// Of the slides among them, what is touched; nothing: all of their groups.
  std::optional<TouchedSeats> touched = {};
  std::vector<Eigen::Index> instants = {};  ///< rising; empty: all

  bool is_at(Eigen::Index instant) const {
    return instants.empty() || std::ranges::binary_search(instants, instant);
  }
};

/// A part and the loads that may buckle it.
struct BucklingProblem {
  Discretization<3> discretization;
  const part::Material& material;
  const loads::LoadHistory& history;
  /// Components held at zero; empty: a free part in balance.
  part::Supports fixed;
  /// Of a free part; each is taken by itself, the lowest factor counts. The
  /// first is at all instants.
  std::vector<HoldingSeats> holds;
  std::string name;               ///< of the part, for messages
  part::Foundations foundations;  ///< elastic beds under faces
  /// Of a plate: what the discretisation is a layer over, of degree 3 through
  /// the thickness. Null: a solid.
  const Discretization<2>* plane = nullptr;
  /// Of energy_coordinates(), where they are known; null: they are made.
  std::shared_ptr<const EnergyCoordinates> coordinates = nullptr;
  /// Of one instant with one hold: a shape near to what is sought, by another
  /// degree. Null: none is known.
  const NodalField<3>* known = nullptr;
  double highest = 100.0;  ///< factors beyond are not looked for [1]
  bool is_pushed = true;   ///< by following forces (SeatPushes)
};

}  // namespace clevis::elasticity
