#pragma once

#include <string>
#include <vector>

#include "elasticity/assembly/equations.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/plate/layered_stiffness.h"
#include "elasticity/plate/plate_layer.h"
#include "part/material.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// What the equations of both parities are made of.
struct Plate {
  const Discretization<2>& plane;
  const Discretization<3>& layer;  ///< over it
  const PlaneIntegrals& integrals;
  const part::Material& material;
  const part::Supports& fixed;  ///< empty: a free part
  const std::string& name;      ///< of the part, for messages
};

/// Stiffness of a plate for one parity, and which terms are solved for.
struct LayeredEquations {
  UpperTriangle stiffness;  ///< of all terms
  /// Terms at zero, sorted: supports, or as many as hold a free part's rigid
  /// motions.
  std::vector<int> held;
  EquationNumbers numbers;
};

/// @throws Error F001 if the supports leave a motion of this parity free.
LayeredEquations layered_equations(const Plate& plate,
                                   const ThicknessReduction& reduction);

/// @param dissection  of the plane.
/// @throws Error F002 if the stiffness is not positive definite.
FrontalCholesky factored(const LayeredEquations& equations,
                         const Dissection& dissection,
                         const ThicknessReduction& reduction,
                         const std::string& place);

}  // namespace clevis::elasticity
