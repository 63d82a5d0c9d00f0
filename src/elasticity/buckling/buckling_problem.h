#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "loads/history/load_history.h"
#include "part/material.h"
#include "part/part_definition.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// A shape that buckles the part, by another degree on the same cells.
struct KnownShape {
  Discretization<3> discretization;
  Eigen::VectorXd shape;  ///< its dofs
};

/// A part and the loads that may buckle it.
struct BucklingProblem {
  Discretization<3> discretization;
  const part::Material& material;
  const loads::LoadHistory& history;
  /// Components held at zero; empty: a free part in balance.
  part::Supports fixed;
  /// Of a free part: pairs of groups whose pins hold it as a whole (PinHold);
  /// each is taken by itself, the lowest factor counts. Not empty.
  std::vector<std::vector<std::string>> holds;
  std::string name;               ///< of the part, for messages
  part::Foundations foundations;  ///< elastic beds under faces
  /// Of a plate: what the discretisation is a layer over, of degree 3 through
  /// the thickness. Null: a solid.
  const Discretization<2>* plane = nullptr;
  /// Of one instant with one hold: near to what is sought. Null: none is known.
  const KnownShape* known = nullptr;
  double highest = 100.0;  ///< factors beyond are not looked for [1]
};

}  // namespace clevis::elasticity
