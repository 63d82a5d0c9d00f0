// Processor seconds of both routes against error: a steel cantilever of
// 9 x 9 x 60 mm struck at its end by 0.2 kg at 1 m/s through a spring.
//
//   strike_routes [DEGREE [CELLS_ALONG]]
//
// The error is that of dynamics::difference against the modal route at 1e-5.
// OPENBLAS_NUM_THREADS=1 gives the conditions of `clevis check`.
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "elasticity/problem/elastic_problem.h"
#include "elasticity/vibration/strike_response.h"
#include "support/structured_mesh.h"

namespace clevis {
namespace {

using dynamics::Route;
using Eigen::Vector3d;

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void run(int degree, int along) {
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  const loads::LoadHistory no_loads;
  const auto mesh = support::structured_mesh<3>(
      {along, 2, 2}, 1, [](const Vector3d& x) -> Vector3d {
        return {0.06 * x[0], 0.009 * (x[1] - 0.5), 0.009 * (x[2] - 0.5)};
      });
  const elasticity::ElasticProblem<3> problem{
      mesh, steel, no_loads, {{"x0", {true, true, true}}}, "cantilever"};
  loads::Strike strike;
  strike.name = "striker";
  strike.group = "x1";
  strike.direction = Vector3d::UnitY();
  strike.mass = 0.2;
  strike.speed = 1.0;
  strike.duration = 1.5e-3;
  for (const double stiffness : {1e6, 1e7, 1e8}) {
    strike.contact.stiffness = stiffness;
    dynamics::StrikeOptions options;
    options.tolerance = 1e-5;
    options.route = Route::kModal;
    const auto exact =
        elasticity::solve_strike(problem, strike, degree, options);
    for (const Route route : {Route::kModal, Route::kDirect}) {
      for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        options.tolerance = tolerance;
        options.route = route;
        const double start = processor_seconds();
        const auto response =
            elasticity::solve_strike(problem, strike, degree, options);
        const auto& solution = response.solution;
        fmt::print(
            "k {:.0e} N/m  {:6}  tolerance {:.0e}  {:7.3f} s  error {:.1e}  "
            "estimated {:.1e}{}  {:3} shapes  {:6} steps  {:6} solves  energy "
            "{:.0e}  peak {:.1f} N  {:.5f} mm\n",
            stiffness, solution.is_modal ? "modal" : "direct", tolerance,
            processor_seconds() - start,
            dynamics::difference(solution.run, exact.solution.run),
            solution.error(), solution.within_tolerance ? "" : " (not within)",
            solution.modes, solution.steps, solution.solves,
            solution.run.energy_error, solution.run.peak_force,
            1e3 * solution.run.peak_contact);
      }
    }
  }
}

}  // namespace
}  // namespace clevis

int main(int argc, char** argv) {
  clevis::run(argc > 1 ? std::atoi(argv[1]) : 2,
              argc > 2 ? std::atoi(argv[2]) : 12);
}
