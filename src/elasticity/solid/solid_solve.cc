#include "elasticity/solid/solid_solve.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "base/system/processor_share.h"
#include "base/values/stopwatch.h"
#include "elasticity/assembly/foundation.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/dealii/dealii_solver.h"
#include "elasticity/direct/memory_forecast.h"
#include "elasticity/mirror_symmetry/folding.h"
#include "elasticity/mirror_symmetry/parity_classes.h"
#include "elasticity/multigrid/block_cg.h"
#include "elasticity/multigrid/large_part.h"
#include "elasticity/multigrid/multigrid_solver.h"
#include "elasticity/nodal_loads/load_basis.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/problem/factored_solve.h"
#include "elasticity/problem/refinement.h"
#include "elasticity/solid/engine_choice.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kCompressionTolerance = 3e-7;

template <int dim>
Precision factor_precision(const Folding<dim>& folding, double columns) {
  return cheaper_precision(folding.factor_flops(), folding.factor_bytes(),
                           columns);
}

/// Of the factors of all classes, kept together [bytes].
template <int dim>
double factors_bytes(const Folding<dim>& folding, double columns) {
  const double share =
      factor_precision(folding, columns) == Precision::kSingle ? 0.5 : 1.0;
  return share * folding.classes() * folding.factor_bytes();
}

template <int dim>
bool uses_multigrid(const ElasticProblem<dim>& problem,
                    const Folding<dim>& folding, double columns) {
  if constexpr (dim == 3) {
    if (problem.solver == LinearSolver::kDirect) return false;
    if (!problem.foundations.empty()) return false;  // it knows no beds
    if (problem.solver == LinearSolver::kMultigrid) {
      return suits_multigrid(folding.part, problem.material);
    }
    const double classes = folding.classes();
    return prefers_multigrid(
        folding.part, problem.material,
        {classes * folding.factor_flops(), classes * folding.factor_bytes()},
        classes * columns, usable_memory());
  } else {
    return false;
  }
}

/// Whether the own engine can hold what it needs.
template <int dim>
bool own_fits(const Folding<dim>& folding, double columns, bool by_multigrid) {
  const Discretization<dim>& part = folding.part;
  const double classes = folding.classes();
  if constexpr (dim == 3) {
    if (by_multigrid) {
      return holds(multigrid_bytes(part.degree, coarse_degree(part),
                                   part.dofs(), classes * columns),
                   usable_memory());
    }
  }
  return holds(factors_bytes(folding, columns), usable_memory());
}

/// Columns that the own multigrid works on, filled up to its lanes.
double whole_blocks(double columns) {
  return kBlockColumns * std::ceil(columns / kBlockColumns);
}

template <int dim>
EngineChoice engine_for(const ElasticProblem<dim>& problem,
                        const Folding<dim>& folding, double columns) {
  const double classes = folding.classes();
  const double dofs = folding.part.dofs();
  const bool by_multigrid = uses_multigrid(problem, folding, columns);
  EngineForecast forecast;
  forecast.own =
      by_multigrid
          ? multigrid_seconds(dofs, classes * whole_blocks(columns))
          : factor_seconds(classes * (folding.factor_flops() +
                                      columns * folding.factor_bytes() / 2.0));
  forecast.dealii = dealii_seconds(dofs, classes, classes * columns);
  forecast.own_fits = own_fits(folding, columns, by_multigrid);
  return choose_engine(problem.engine, folding.part, columns, forecast,
                       problem.is_shared, "part " + problem.name);
}

/// Before the loads are assembled, with as many columns as there may be.
template <int dim>
void require_memory_for(const ElasticProblem<dim>& problem,
                        const Folding<dim>& folding, const std::string& place) {
  constexpr double kMostColumns = 60.0;
  const Discretization<dim>& part = folding.part;
  const double classes = folding.classes();
  const double columns = std::min(
      static_cast<double>(problem.history.instants.size()), kMostColumns);
  if (engine_for(problem, folding, columns).engine == Engine::kDealii) {
    require_dealii_memory(part.dofs(), usable_memory(), place);
    return;
  }
  if constexpr (dim == 3) {
    if (uses_multigrid(problem, folding, columns)) {
      require_multigrid_memory(part.degree, coarse_degree(part), part.dofs(),
                               classes * columns, usable_memory(), place);
      return;
    }
  }
  require_memory(factors_bytes(folding, columns), classes * part.dofs(),
                 usable_memory(), place);
}

/// The folded part, which has no groups, with the bed of the whole.
template <int dim>
struct BeddedPart {
  BeddedPart(const ElasticProblem<dim>& problem, const Folding<dim>& folding,
             const Discretization<dim>& whole)
      : material(problem.material),
        folded(folding.part),
        bed(whole, problem.foundations, problem.name) {
    bed.renumber(folding.node);
  }

  /// By strains [N]. @param u  displacements, dofs × columns [m].
  MatrixXd forces(const MatrixXd& u) const {
    MatrixXd sum = forces_by_strain(folded, material, u);
    bed.add_forces(u, sum);
    return sum;
  }

  const part::Material& material;
  const Discretization<dim>& folded;
  FoundationStiffness<dim> bed;
};

/// One factorisation per class; fills the classes' columns, the checks, the
/// strain energy and the seconds.
template <int dim>
void solve_by_factors(const ElasticProblem<dim>& problem,
                      const Folding<dim>& folding, const LoadBasis& loads,
                      const std::string& place,
                      std::vector<ParityClass>& classes,
                      DisplacementBasis<dim>& result) {
  Stopwatch watch;
  const BeddedPart<dim> bedded(problem, folding, result.discretization);
  const Discretization<dim>& part = folding.part;
  auto stiffness = assemble_stiffness(part, problem.material, place);
  bedded.bed.add_to(stiffness);
  for (ParityClass& c : classes) {
    c.numbers = number_equations(part.dofs(), c.held);
    result.seconds.assemble += watch.lap();
    FactoredSolution solved = solve_by_factor(
        free_rows(stiffness, c.numbers),
        front_tree(folding.dissection, dim, c.numbers.equation),
        [&](const MatrixXd& x) {
          return restrict_rows(stiffness.multiply(extend_rows(x, c.numbers)),
                               c.numbers);
        },
        restrict_rows(c.loads.columns, c.numbers),
        {factor_precision(folding, static_cast<double>(c.loads.columns.cols())),
         own_processors()},
        place);
    result.seconds.factor += solved.factor_seconds;
    result.seconds.solve += solved.solve_seconds;
    c.inverse = std::move(solved.inverse);
    c.columns = extend_rows(solved.columns, c.numbers);
    watch.lap();
  }
  const auto check = [&](const StiffnessAction& action) {
    result.strain_energy =
        check_classes(action, classes, folding.classes(), loads, result.checks);
  };
  check(action_of(stiffness));
  if (wants_refinement(result.checks)) {
    const StiffnessAction by_strain{[&](const MatrixXd& u) {
                                      return bedded.forces(u);
                                    },
                                    action_of(stiffness).multiply_absolute};
    for (ParityClass& c : classes) {
      refine(by_strain, c.inverse, c.numbers, c.loads, c.columns);
    }
    check(by_strain);
  }
  result.seconds.solve += watch.lap();
}

/// Likewise without factors: `seconds.factor` is the preconditioner's setup.
template <int dim>
void solve_by_multigrid(const ElasticProblem<dim>& problem,
                        const Folding<dim>& folding, const LoadBasis& loads,
                        const std::string& place,
                        std::vector<ParityClass>& classes,
                        DisplacementBasis<dim>& result) {
  if constexpr (dim == 3) {
    Stopwatch watch;
    std::unique_ptr<MultigridSolver> solver;
    for (ParityClass& c : classes) {
      solver.reset();  // before the next: memory
      solver = std::make_unique<MultigridSolver>(folding.part, problem.material,
                                                 c.held, place);
      result.seconds.factor += watch.lap();
      c.columns = solver->solve(c.loads.columns);
      result.seconds.solve += watch.lap();
    }
    // K with the rows of the supports is the same for all classes.
    const StiffnessAction action{[&](const MatrixXd& u) {
                                   return solver->multiply(u);
                                 },
                                 [&](const MatrixXd& u) {
                                   return solver->multiply_absolute_diagonal(u);
                                 }};
    result.strain_energy =
        check_classes(action, classes, folding.classes(), loads, result.checks);
    result.seconds.solve += watch.lap();
  }
}

/// Likewise by deal.II and PETSc. Its solutions are checked by the strains of
/// our own kernels, not by its own operator.
template <int dim>
void solve_by_dealii(const ElasticProblem<dim>& problem,
                     const Folding<dim>& folding, const LoadBasis& loads,
                     const std::string& place,
                     std::vector<ParityClass>& classes,
                     DisplacementBasis<dim>& result) {
  Stopwatch watch;
  const BeddedPart<dim> bedded(problem, folding, result.discretization);
  std::unique_ptr<DealiiSolver<dim>> solver;
  int iterations = 0;
  for (ParityClass& c : classes) {
    solver.reset();  // before the next: memory
    solver = std::make_unique<DealiiSolver<dim>>(folding.part, problem.material,
                                                 bedded.bed, c.held, place,
                                                 problem.is_shared);
    result.seconds.factor += watch.lap();
    c.columns = solver->solve(c.loads.columns);
    iterations = std::max(iterations, solver->report().iterations);
    result.seconds.solve += watch.lap();
  }
  result.engine.why += fmt::format("; at most {} iterations over {} degrees",
                                   iterations, solver->report().levels);
  if (const double sent = solver->report().bytes_sent; sent > 0.0) {
    result.engine.why += fmt::format(
        ", {:.1f} kB between ranks in each product with K", 1e-3 * sent);
  }
  const StiffnessAction action{[&](const MatrixXd& u) {
                                 return bedded.forces(u);
                               },
                               [&](const MatrixXd& u) {
                                 return solver->multiply_absolute_diagonal(u);
                               }};
  result.strain_energy =
      check_classes(action, classes, folding.classes(), loads, result.checks);
  result.seconds.solve += watch.lap();
}

/// Of a free part in balance.
template <int dim>
LoadBasis compressed_loads(
    const ElasticProblem<dim>& problem, const Discretization<dim>& whole,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions,
    SolveChecks& checks) {
  const double density = problem.material.density;
  SplitLoads all = load_columns(whole, problem.history, density, problem.name);
  if (problem.fixed.empty() && problem.foundations.empty()) {
    balance_free_part<dim>(whole, positions, density, all, checks);
  }
  return compress(all, kCompressionTolerance, 0.0, problem.admitted_load_error);
}

}  // namespace

template <int dim>
DisplacementBasis<dim> solve(const ElasticProblem<dim>& problem, int degree) {
  Stopwatch watch;
  const std::string place = "part " + problem.name;
  const bool has_bed = !problem.foundations.empty();
  const bool is_free = problem.fixed.empty() && !has_bed;
  DisplacementBasis<dim> result;
  result.discretization = discretize(problem.mesh, degree);
  const auto& whole = result.discretization;
  require_dofs(whole.dofs(), problem.max_dofs, place);
  if (problem.tell_dofs) problem.tell_dofs(whole.dofs());
  const auto positions = node_positions(whole);
  std::vector<int> fixed;
  if (!is_free) {
    const FoundationStiffness<dim> bed(whole, problem.foundations,
                                       problem.name);
    fixed = fixed_supports(whole, positions, problem.fixed, place, &bed);
  }
  const Folding<dim> folding =
      fold<dim>(whole, positions,
                has_bed ? std::vector<Mirror>{}
                        : common_mirrors<dim>(whole, positions, fixed));
  const Discretization<dim>& part = folding.part;
  require_memory_for(problem, folding, place);
  LoadBasis loads = compressed_loads(problem, whole, positions, result.checks);
  if (is_free) {
    restore_balance(
        rigid_modes<dim>(positions, positions.rowwise().mean(), 1.0),
        loads.columns);
  }
  result.checks.compression = loads.compression_error;
  result.coefficients = loads.coefficients;
  const auto folded_positions = node_positions(part);
  auto classes = loaded_classes<dim>(folding, folded_positions, loads, is_free,
                                     result.checks.compression);
  for (ParityClass& c : classes) {
    if (has_bed && fixed.empty()) continue;  // its bed alone holds it
    hold<dim>(folding, fixed, folded_positions, c);
  }
  result.seconds.assemble = watch.lap();
  const auto columns = static_cast<double>(loads.columns.cols());
  result.engine = engine_for(problem, folding, columns);
  if (result.engine.engine == Engine::kDealii) {
    solve_by_dealii(problem, folding, loads, place, classes, result);
  } else if (uses_multigrid(problem, folding, columns)) {
    solve_by_multigrid(problem, folding, loads, place, classes, result);
  } else {
    solve_by_factors(problem, folding, loads, place, classes, result);
  }
  watch.lap();
  result.columns = MatrixXd::Zero(whole.dofs(), loads.columns.cols());
  for (const ParityClass& c : classes) {
    add_unfolded(folding, c.parity, c.columns, result.columns);
  }
  result.seconds.solve += watch.lap();
  require_checks(result.checks, whole.geometry_degree, problem.name);
  return result;
}

template DisplacementBasis<2> solve<2>(const ElasticProblem<2>&, int);
template DisplacementBasis<3> solve<3>(const ElasticProblem<3>&, int);

}  // namespace clevis::elasticity
