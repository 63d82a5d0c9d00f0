#include "elasticity/solid/engine_choice.h"

#include <fmt/format.h>

#include "elasticity/dealii/dealii_solver.h"

namespace clevis::elasticity {

double dealii_seconds(double dofs, double classes, double columns) {
  // Processor seconds of the landing gear's rod FE2, refined twice and thrice,
  // degrees 1 to 3, 5 columns, lanes of AVX2.
  constexpr double kSecondsToLoad = 0.4;      // the library
  constexpr double kSecondsOfSetup = 5e-6;    // per degree of freedom
  constexpr double kSecondsPerColumn = 6e-6;  // and degree of freedom
  return kSecondsToLoad +
         dofs * (classes * kSecondsOfSetup + columns * kSecondsPerColumn);
}

template <int dim>
EngineChoice choose_engine(Engine asked, const Discretization<dim>& part,
                           double columns, const EngineForecast& forecast,
                           bool is_shared, const std::string& place) {
  if (asked == Engine::kDealii) require_suits_dealii(part, place);
  if (asked != Engine::kAuto) return {asked, "asked for"};
  if (!suits_dealii(part)) return {Engine::kOwn, "deal.II has no simplices"};
  if (is_shared) return {Engine::kDealii, "ranks of MPI share the part"};
  if (!forecast.own_fits) {
    return {Engine::kDealii, "the own engine's factors do not fit into memory"};
  }
  const bool own = forecast.own <= forecast.dealii;
  return {own ? Engine::kOwn : Engine::kDealii,
          fmt::format("{} degrees of freedom, {} columns: own {:.2g} s, "
                      "deal.II {:.2g} s forecast",
                      part.dofs(), columns, forecast.own, forecast.dealii)};
}

template EngineChoice choose_engine<2>(Engine, const Discretization<2>&, double,
                                       const EngineForecast&, bool,
                                       const std::string&);
template EngineChoice choose_engine<3>(Engine, const Discretization<3>&, double,
                                       const EngineForecast&, bool,
                                       const std::string&);

}  // namespace clevis::elasticity
