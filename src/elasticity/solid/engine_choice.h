#pragma once

#include <string>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/engine.h"

namespace clevis::elasticity {

/// Forecast of the engines' time and memory for one problem.
struct EngineForecast {
  double own{}, dealii{};  ///< [s] of one core
  bool own_fits = true;    ///< into memory
};

/// Seconds of deal.II and PETSc on one core.
/// @param columns  right-hand sides of all parity classes together.
double dealii_seconds(double dofs, double classes, double columns);

/// The engine that is asked for, else the cheaper one.
/// @param columns  of loads, for the message.
/// @param is_shared  among ranks of MPI, which only deal.II knows.
/// @param place  of an error, e.g. "part DCE".
/// @throws Error F005 if deal.II is asked for and does not suit.
template <int dim>
EngineChoice choose_engine(Engine asked, const Discretization<dim>& part,
                           double columns, const EngineForecast& forecast,
                           bool is_shared, const std::string& place);

}  // namespace clevis::elasticity
