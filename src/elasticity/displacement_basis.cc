#include "elasticity/displacement_basis.h"

#include "base/stopwatch.h"
#include "elasticity/equations.h"
#include "elasticity/load_basis.h"
#include "elasticity/load_vectors.h"
#include "elasticity/memory_forecast.h"
#include "elasticity/refinement.h"
#include "elasticity/sparse_cholesky.h"
#include "elasticity/stiffness.h"
#include "elasticity/supports.h"

namespace clevis::elasticity {

template <int dim>
DisplacementBasis<dim> solve(const ElasticProblem<dim>& problem, int degree) {
  constexpr double kCompressionTolerance = 3e-7;
  Stopwatch watch;
  const std::string place = "part " + problem.name;
  const double density = problem.material.density;
  DisplacementBasis<dim> result;
  result.discretization = discretize(problem.mesh, degree);
  const auto& discretization = result.discretization;
  require_memory(dim, discretization.dofs(), physical_memory(), place);
  const auto positions = node_positions(discretization);
  const auto stiffness =
      assemble_stiffness(discretization, problem.material, place);
  const bool is_free = problem.fixed.empty();
  const std::vector<int> held =
      is_free ? determinate_supports(discretization, positions)
              : fixed_supports(discretization, positions, problem.fixed, place);
  Eigen::MatrixXd history =
      assemble_loads(discretization, problem.history, density, problem.name);
  if (is_free) {
    balance_free_part<dim>(discretization, positions, density, history,
                           result.checks);
  }
  const LoadBasis loads = compress(history, kCompressionTolerance);
  result.checks.compression = loads.compression_error;
  result.coefficients = loads.coefficients;
  const auto numbers = number_equations(discretization.dofs(), held);
  const UpperTriangle upper = free_equations(stiffness, numbers);
  result.seconds.assemble = watch.lap();

  const SparseCholesky cholesky(upper, place);
  result.seconds.factor = watch.lap();

  result.columns = extend_rows(
      cholesky.solve(restrict_rows(loads.columns, numbers)), numbers);
  result.strain_energy = check_solution(action_of(stiffness), result.columns,
                                        loads, held, is_free, result.checks);
  if (wants_refinement(result.checks)) {
    const StiffnessAction by_strain{[&](const Eigen::MatrixXd& u) {
                                      return forces_by_strain(
                                          discretization, problem.material, u);
                                    },
                                    action_of(stiffness).multiply_absolute};
    refine(by_strain, cholesky, numbers, loads, result.columns);
    result.strain_energy = check_solution(by_strain, result.columns, loads,
                                          held, is_free, result.checks);
  }
  result.seconds.solve = watch.lap();
  require_checks(result.checks, discretization.geometry_degree, problem.name);
  return result;
}

template DisplacementBasis<2> solve<2>(const ElasticProblem<2>&, int);
template DisplacementBasis<3> solve<3>(const ElasticProblem<3>&, int);

}  // namespace clevis::elasticity
