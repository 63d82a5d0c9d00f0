#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/buckling/energy_coordinates.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/holds/pin_hold.h"
#include "elasticity/problem/nodal_field.h"
#include "loads/history/load_history.h"
#include "part/mass_properties.h"
#include "part/material.h"
#include "part/part_definition.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// A part and the loads that may buckle it.
struct BucklingProblem {
  Discretization<3> discretization;
  const part::Material& material;
  const loads::LoadHistory& history;
  /// Components held at zero; empty: a free part in balance.
  part::Supports fixed;
  /// Of a free part; each is taken by itself, the lowest factor counts. Every
  /// instant has one.
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
  /// Null: nothing is said of how fast its loads push it over.
  const part::MassProperties* mass = nullptr;
  double highest = 100.0;  ///< factors beyond are not looked for [1]
  double enough = 10.0;    ///< of a part on springs, beyond which none is [1]
};

}  // namespace clevis::elasticity
