// Seconds of assembly, factorisation, block solve and recovery of one part
// without any symmetry, and the rate of the matrix product in the same run.
//
//   direct_solve NX NY NZ DEGREE [COLUMNS [INSTANTS]]
//
// OPENBLAS_NUM_THREADS=1 gives the conditions of `clevis check`.
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/values/stopwatch.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/problem/displacement_basis.h"
#include "stress/field/stress_history.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

double product_rate() {
  const MatrixXd a = MatrixXd::Random(1000, 1000);
  MatrixXd c = product(a, a);  // warms up
  Stopwatch watch;
  c = product(a, c);
  return 2e9 / watch.lap();
}

void run(std::array<int, 3> cells, int degree, int columns, int instants) {
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  const auto mesh =
      support::structured_mesh<3>(cells, 2, [&](const Vector3d& x) -> Vector3d {
        const double angle = 0.3 * x[0];
        const double radius = 10.0 + x[1] * cells[1] / cells[0];
        return {radius * std::sin(angle), radius * std::cos(angle),
                x[2] * cells[2] / cells[0]};
      });
  Stopwatch watch;
  DisplacementBasis<3> basis;
  basis.discretization = discretize<3>(mesh, degree);
  const auto& part = basis.discretization;
  const double discretized = watch.lap();
  const auto stiffness = assemble_stiffness(part, steel, "block");
  const auto held = fixed_supports(part, node_positions(part),
                                   {{"x0", {true, true, true}}}, "block");
  const auto numbers = number_equations(part.dofs(), held);
  const UpperTriangle upper = free_equations(stiffness, numbers);
  const double assembled = watch.lap();
  const Dissection dissection = dissect(part);
  const FrontalCholesky factor(
      upper, front_tree(dissection, 3, numbers.equation), "block");
  const double factored = watch.lap();
  const MatrixXd loads = MatrixXd::Random(numbers.count, columns);
  watch.lap();
  basis.columns = extend_rows(factor.solve(loads), numbers);
  const double solved = watch.lap();
  basis.coefficients = MatrixXd::Random(columns, instants);
  watch.lap();
  const double peak = stress::stress_history<3>(basis, steel, 4).largest();
  const double recovered = watch.lap();
  fmt::print(
      "{} dofs, p = {}, {} columns, {} instants (peak {:.3g} Pa)\n"
      "discretize {:.3f} s, assemble {:.3f} s, factor {:.3f} s, solve {:.3f} "
      "s, recover {:.3f} s; matrix product {:.1f} GFlop/s\n"
      "forecast: {:.3g} GFlop, {:.3g} GB of factor\n",
      part.dofs(), degree, columns, instants, peak, discretized, assembled,
      factored, solved, recovered, product_rate() * 1e-9,
      27e-9 * dissection.flops, 72e-9 * dissection.entries);
}

}  // namespace
}  // namespace clevis::elasticity

int main(int count, char** words) {
  const auto number = [&](int k, int otherwise) {
    return k < count ? std::atoi(words[k]) : otherwise;
  };
  clevis::elasticity::run({number(1, 20), number(2, 20), number(3, 20)},
                          number(4, 2), number(5, 40), number(6, 201));
}
