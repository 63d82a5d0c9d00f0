// Throughput and time to solution of large parts, with the memory bandwidth
// of the same run.
//
//   large_parts operator [dofs]       million DoF a second per degree
//   large_parts iterations            against the aspect of body and cells
//   large_parts solve DOFS [columns [degree [coarse degree [steps]]]]
//                                     seconds and peak memory per degree
//   large_parts part DOFS [degree]    an eye from mesh to stress
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>

#include "base/values/stopwatch.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/multigrid/matrix_free_operator.h"
#include "elasticity/multigrid/multigrid_solver.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/field/stress_history.h"
#include "support/eye_problem.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

/// A bar of length × width × height, bent along x: curved cells.
mesh::PartMesh<3> bar(const Eigen::Vector3d& size, std::array<int, 3> cells) {
  return support::structured_mesh<
      3>(cells, 2, [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    const double angle = 0.5 * x[0];
    const double radius = size[0] / 0.5 + size[1] * (x[1] - 0.5);
    return {radius * std::sin(angle), radius * std::cos(angle), size[2] * x[2]};
  });
}

/// A bar of size with about so many degrees of freedom, cells near cubes.
mesh::PartMesh<3> bar_of(const Eigen::Vector3d& size, int degree, double dofs) {
  const double h = degree * std::cbrt(size.prod() / (dofs / 3.0));
  std::array<int, 3> cells{};
  for (std::size_t d = 0; d < 3; ++d) {
    cells[d] = std::max(
        1, static_cast<int>(size[static_cast<Eigen::Index>(d)] / h + 0.5));
  }
  return bar(size, cells);
}

/// Triad a = b + s c on all threads: bytes a second, the write's own read
/// counted. Best of several.
double bandwidth(ThreadTeam& team) {
  constexpr int kSize = 1 << 24;
  const LaneVector<double> b(kSize / 24);
  const LaneVector<double> c(kSize / 24);
  LaneVector<double> a(kSize / 24);
  const int tasks = 64;
  const int part = kSize / 24 * 24 / tasks;
  double best = 1e9;
  for (int repeat = 0; repeat < 12; ++repeat) {
    Stopwatch watch;
    team.run(tasks, [&](int task) {
      double* to = a.data() + static_cast<std::ptrdiff_t>(task) * part;
      double* x = const_cast<double*>(b.data()) +
                  static_cast<std::ptrdiff_t>(task) * part;
      double* y = const_cast<double*>(c.data()) +
                  static_cast<std::ptrdiff_t>(task) * part;
      if (repeat == 0) {  // first touch
        std::fill_n(to, part, 0.0);
        std::fill_n(x, part, 1.0);
        std::fill_n(y, part, 2.0);
      }
      for (int i = 0; i < part; ++i) to[i] = x[i] + 3.0 * y[i];
    });
    if (repeat > 0) best = std::min(best, watch.lap());
  }
  return 32.0 * part * tasks / best;
}

template <typename Real>
void time_operator(int degree, int extra_points, double dofs,
                   double bytes_per_second, ThreadTeam& team) {
  const auto discretization =
      discretize<3>(bar_of({0.4, 0.2, 0.1}, degree, dofs), degree);
  const auto schedule = schedule_cells(discretization);
  const auto fine = number_nodes(discretization, schedule);
  const MatrixFreeOperator<Real> stiffness(
      discretization, schedule, fine.table, degree + extra_points,
      lame_constants<3>(kSteel), {}, team, "part P");
  LaneVector<Real> x(fine.table.nodes);
  LaneVector<Real> y(fine.table.nodes);
  std::fill_n(x.data(),
              static_cast<std::size_t>(x.nodes()) * lanes::kNode<Real>,
              Real{1});
  double best = 1e9;
  double least_cpu = 1e9;  // of all threads: what a busy machine leaves alone
  for (int repeat = 0; repeat < 20; ++repeat) {
    Stopwatch watch;
    const std::clock_t start = std::clock();
    stiffness.apply(x, y);
    least_cpu = std::min(
        least_cpu, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    best = std::min(best, watch.lap());
  }
  const double columns = lanes::kLanes<Real>;
  const double limit = stiffness.traffic() / bytes_per_second;
  fmt::print(
      "p={} {} q={} {:8} DoF: {:6.1f} million DoF/s ({:5.1f} per "
      "core second), {:5.1f} bytes/DoF, "
      "{:4.1f} % of the traffic limit\n",
      degree, sizeof(Real) == 8 ? "double" : "single", degree + extra_points,
      discretization.dofs(), discretization.dofs() * columns / best / 1e6,
      discretization.dofs() * columns / least_cpu / 1e6,
      stiffness.traffic() / discretization.dofs() / columns,
      100.0 * limit / best);
}

double peak_gigabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1e6;
}

/// Smooth and rough loads, in balance or not: supports take what is left.
Eigen::MatrixXd loads(const Discretization<3>& discretization, int columns) {
  const auto positions = node_positions(discretization);
  Eigen::MatrixXd result(discretization.dofs(), columns);
  for (int j = 0; j < columns; ++j) {
    for (Eigen::Index n = 0; n < positions.cols(); ++n) {
      for (int c = 0; c < 3; ++c) {
        result(3 * n + c, j) =
            std::sin((7.0 + j) * positions(0, n) + 3.0 * c + j) +
            std::cos(91.0 * positions(1, n) + j * c);
      }
    }
  }
  return result;
}

std::vector<int> clamp(const Discretization<3>& discretization) {
  return fixed_supports<3>(discretization, node_positions(discretization),
                           {{"x0", {true, true, true}}}, "part P");
}

void time_solve(const Discretization<3>& discretization, int columns,
                const std::string& what, const MultigridOptions& options = {}) {
  const auto held = clamp(discretization);
  const Eigen::MatrixXd right = loads(discretization, columns);
  Stopwatch watch;
  const std::clock_t start = std::clock();
  MultigridSolver solver(discretization, kSteel, held, "part P", options);
  const Eigen::MatrixXd u = solver.solve(right);
  const double seconds = watch.lap();
  const double cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const auto& report = solver.report();
  fmt::print(
      "{} p={} {:8} DoF {} columns: {} iterations, residual {:.1e}, "
      "{:.2f} s ({:.2f} core s) = setup {:.2f} + solve {:.2f} (coarse {:.2f}), "
      "{:.2f} µs/DoF/column, {:.2f} GB at most\n",
      what, discretization.degree, discretization.dofs(), columns,
      report.iterations, report.residual, seconds, cpu, report.setup_seconds,
      report.solve_seconds, report.coarse_seconds,
      1e6 * seconds / discretization.dofs() / columns, peak_gigabytes());
  std::fflush(stdout);
}

/// A ring under 40 pin directions, as `clevis check` solves a part: loads,
/// mirrors, supports, self-checks and stresses included.
void time_part(int degree, double dofs) {
  auto eye = support::eye_problem(40);
  const double h = degree * std::cbrt(3.0 * 7.54e-6 / dofs);  // its volume
  const auto count = [&](double length) {
    return std::max(1, static_cast<int>(length / h + 0.5));
  };
  eye.mesh = support::ring_mesh<3>({.inner = 0.01,
                                    .outer = 0.02,
                                    .thickness = 0.008,
                                    .radial = count(0.01),
                                    .angular = count(0.094),
                                    .axial = count(0.008),
                                    .degree = 2});
  Stopwatch watch;
  const auto basis = solve(eye.problem(), degree);
  const double solved = watch.lap();
  const auto stress = stress::stress_history(basis, eye.material, 4);
  const double stressed = watch.lap();
  fmt::print(
      "eye p={} {} DoF, {} columns: peak {:.4g} MPa; assemble {:.2f} + "
      "factor {:.2f} + solve {:.2f} of {:.2f} s, stresses {:.2f} s, "
      "{:.2f} GB at most\n",
      degree, basis.discretization.dofs(), basis.columns.cols(),
      1e-6 * stress.largest(), basis.seconds.assemble, basis.seconds.factor,
      basis.seconds.solve, solved, stressed, peak_gigabytes());
}

void iterations() {
  for (double tolerance : {1e-8}) {
    MultigridOptions options;
    options.tolerance = tolerance;
    for (int degree = 2; degree <= 4; ++degree) {
      for (int aspect : {1, 10, 100}) {
        const int across = degree == 2 ? 4 : 2;
        time_solve(discretize<3>(bar({0.02 * aspect, 0.02, 0.02},
                                     {across * aspect, across, across}),
                                 degree),
                   16, fmt::format("tolerance {} body 1:{}", tolerance, aspect),
                   options);
      }
      for (int aspect : {2, 4, 10, 100}) {
        time_solve(
            discretize<3>(bar({0.8 * aspect, 0.8 * aspect, 0.4}, {8, 8, 4}),
                          degree),
            16, fmt::format("tolerance {} flat cells 1:{}", tolerance, aspect),
            options);
        time_solve(
            discretize<3>(bar({0.8 * aspect, 0.4, 0.4}, {8, 4, 4}), degree), 16,
            fmt::format("tolerance {} long cells 1:{}", tolerance, aspect),
            options);
      }
    }
  }
}

void measure_operator(double dofs) {
  ThreadTeam team(machine_threads());
  const double bytes = bandwidth(team);
  fmt::print("{} threads, triad {:.1f} GB/s\n", team.threads(), bytes / 1e9);
  for (int degree = 2; degree <= 4; ++degree) {
    time_operator<double>(degree, 2, dofs, bytes, team);
    time_operator<double>(degree, 1, dofs, bytes, team);
    time_operator<float>(degree, 1, dofs, bytes, team);
  }
}

}  // namespace
}  // namespace clevis::elasticity

int main(int argc, char** argv) {
  using namespace clevis::elasticity;
  const std::string what = argc > 1 ? argv[1] : "operator";
  const double dofs = argc > 2 ? std::atof(argv[2]) : 1e6;
  if (what == "operator") measure_operator(dofs);
  if (what == "iterations") iterations();
  if (what == "part") time_part(argc > 3 ? std::atoi(argv[3]) : 2, dofs);
  if (what == "solve") {
    const int columns = argc > 3 ? std::atoi(argv[3]) : 40;
    for (int degree = 2; degree <= 4; ++degree) {
      if (argc > 4 && std::atoi(argv[4]) != degree) continue;
      MultigridOptions options;
      if (argc > 5) options.coarse_degree = std::atoi(argv[5]);
      if (argc > 6) options.smoothing_steps = std::atoi(argv[6]);
      time_solve(discretize<3>(bar_of({0.4, 0.2, 0.1}, degree, dofs), degree),
                 columns, "body 4:2:1", options);
    }
  }
  return 0;
}
