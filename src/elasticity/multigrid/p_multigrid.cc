#include "elasticity/multigrid/p_multigrid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "base/values/stopwatch.h"
#include "elasticity/algebra/sparse_cholesky.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/multigrid/large_part.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {
namespace {

constexpr int kLanes = lanes::kLanes<float>;

/// Stretched cells leave small eigenvalues that no coarser degree has: there
/// twice the steps halve the cycles.
int smoothing_steps(const Discretization<3>& discretization) {
  constexpr int kSteps = 4;
  constexpr double kStretched = 1.5;
  return cell_aspect(discretization) > kStretched ? 2 * kSteps : kSteps;
}

/// Inverses of the diagonal blocks, held components left out.
std::vector<float> inverse_blocks(
    const std::vector<std::array<double, 6>>& blocks,
    const std::vector<int>& held) {
  std::vector<bool> is_held(3 * blocks.size(), false);
  for (int dof : held) is_held[static_cast<std::size_t>(dof)] = true;
  std::vector<float> inverses;
  inverses.reserve(6 * blocks.size());
  for (std::size_t node = 0; node < blocks.size(); ++node) {
    const auto& b = blocks[node];
    Eigen::Matrix3d block;
    block << b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5];
    for (int c = 0; c < 3; ++c) {
      if (!is_held[3 * node + static_cast<std::size_t>(c)]) continue;
      block.row(c).setZero();
      block.col(c).setZero();
      block(c, c) = 1.0;
    }
    const Eigen::Matrix3d inverse = block.inverse();
    for (int a = 0; a < 3; ++a) {
      for (int c = a; c < 3; ++c) {
        inverses.push_back(static_cast<float>(inverse(a, c)));
      }
    }
  }
  return inverses;
}

/// Values at the Gauss–Lobatto points of degree `fine` of the polynomials of
/// degree `coarse` on theirs.
Eigen::MatrixXd interpolation(int fine, int coarse) {
  return mesh::lagrange(mesh::gauss_lobatto(coarse), mesh::gauss_lobatto(fine))
      .value;
}

/// Coarse degrees of freedom that reach a held fine one.
std::vector<int> coarse_held(const NodeTable& fine,
                             const std::vector<int>& held,
                             const NodeTable& coarse, int cells) {
  std::vector<bool> is_held(3 * static_cast<std::size_t>(fine.nodes), false);
  for (int dof : held) is_held[static_cast<std::size_t>(dof)] = true;
  const Eigen::MatrixXd weight = interpolation(fine.degree, coarse.degree);
  const int n = fine.degree + 1;
  const int m = coarse.degree + 1;
  const auto reaches = [&](int to, int from) {
    return std::abs(weight(to % n, from % m)) > 1e-9 &&
           std::abs(weight(to / n % n, from / m % m)) > 1e-9 &&
           std::abs(weight(to / (n * n), from / (m * m))) > 1e-9;
  };
  std::vector<int> result;
  for (std::ptrdiff_t cell = 0; cell < cells; ++cell) {
    const int* to = fine.gather.data() + cell * n * n * n;
    const int* from = coarse.gather.data() + cell * m * m * m;
    for (int i = 0; i < n * n * n; ++i) {
      for (int c = 0; c < 3; ++c) {
        if (!is_held[static_cast<std::size_t>(3 * to[i] + c)]) continue;
        for (int j = 0; j < m * m * m; ++j) {
          if (reaches(i, j)) result.push_back(3 * from[j] + c);
        }
      }
    }
  }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// The coarsest level's nodes as a discretisation that can be assembled.
Discretization<3> coarse_discretization(const Discretization<3>& fine,
                                        const CellSchedule& schedule,
                                        const NodeTable& nodes) {
  Discretization<3> coarse;
  coarse.shape = fine.shape;
  coarse.degree = coarse.thickness_degree = nodes.degree;
  coarse.geometry_degree = fine.geometry_degree;
  coarse.geometry_thickness_degree = fine.geometry_thickness_degree;
  coarse.nodes = nodes.nodes;
  const auto order = lexicographic_order(nodes.degree);
  for (std::size_t place = 0; place < schedule.cell.size(); ++place) {
    coarse.cell_points.push_back(
        fine.cell_points[static_cast<std::size_t>(schedule.cell[place])]);
    auto& ids = coarse.cell_nodes.emplace_back(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      ids[static_cast<std::size_t>(order[i])] =
          nodes.gather[place * order.size() + i];
    }
  }
  return coarse;
}

/// Repeatable numbers in [-1, 1].
float noise(std::uint64_t index) {
  std::uint64_t z = (index + 1) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return static_cast<float>(static_cast<double>(z >> 11) * 0x1p-52 - 1.0);
}

using LaneSums = Eigen::Array<double, kLanes, 1>;
using ConstLanes = Eigen::Map<const Eigen::Array<float, kLanes, 1>>;
using Lanes = Eigen::Map<Eigen::Array<float, kLanes, 1>>;

LaneSums dot(const LaneVector<float>& a, const LaneVector<float>& b) {
  LaneSums sum = LaneSums::Zero();
  for (int node = 0; node < a.nodes(); ++node) {
    for (int c = 0; c < 3; ++c) {
      sum += (ConstLanes(a.at(node, c)) * ConstLanes(b.at(node, c)))
                 .cast<double>();
    }
  }
  return sum;
}

/// y = a x + b y, lane by lane.
void combine(const LaneSums& a, const LaneVector<float>& x, const LaneSums& b,
             LaneVector<float>& y) {
  const Eigen::Array<float, kLanes, 1> fa = a.cast<float>();
  const Eigen::Array<float, kLanes, 1> fb = b.cast<float>();
  for (int node = 0; node < x.nodes(); ++node) {
    for (int c = 0; c < 3; ++c) {
      Lanes to(y.at(node, c));
      to = fa * ConstLanes(x.at(node, c)) + fb * to;
    }
  }
}

}  // namespace

/// A level above the coarsest.
struct PMultigrid::Level {
  NodeTable own_nodes;  // of an inner level
  const NodeTable* nodes{};
  std::vector<int> held;
  std::unique_ptr<MatrixFreeOperator<float>> stiffness;
  std::vector<float> inverse_blocks;
  double largest_eigenvalue{};
  std::vector<float> interpolation;  // from the next level, row by row
  std::unique_ptr<LaneVector<float>> step, change;
  std::unique_ptr<LaneVector<float>> residual, solution;  // of an inner level
};

struct PMultigrid::Coarsest {
  NodeTable nodes;
  EquationNumbers numbers;
  std::unique_ptr<SparseCholesky> factor;
  std::unique_ptr<LaneVector<float>> residual, solution, ghost;
  double seconds{};

  void solve() {
    Stopwatch watch;
    Eigen::MatrixXd right(numbers.count, kLanes);
    for (std::size_t dof = 0; dof < numbers.equation.size(); ++dof) {
      if (numbers.equation[dof] < 0) continue;
      const int at = static_cast<int>(dof);
      right.row(numbers.equation[dof]) =
          ConstLanes(residual->at(at / 3, at % 3)).cast<double>().transpose();
    }
    const Eigen::MatrixXd left = factor->solve(right);
    for (std::size_t dof = 0; dof < numbers.equation.size(); ++dof) {
      const int at = static_cast<int>(dof);
      Lanes to(solution->at(at / 3, at % 3));
      if (numbers.equation[dof] < 0) {
        to.setZero();
      } else {
        to = left.row(numbers.equation[dof]).transpose().cast<float>().array();
      }
    }
    seconds += watch.lap();
  }
};

int coarse_degree(const Discretization<3>& discretization) {
  constexpr double kLargest = 5e4;  // degrees of freedom, to factor
  const double shrink = std::pow(2.0 / discretization.degree, 3);
  return discretization.degree > 2 && shrink * discretization.dofs() < kLargest
             ? 2
             : 1;
}

PMultigrid::PMultigrid(const Discretization<3>& discretization,
                       const part::Material& material,
                       const CellSchedule& schedule, const NodeTable& fine,
                       const std::vector<int>& held,
                       const MultigridOptions& options, ThreadTeam& team,
                       const std::string& place)
    : schedule_(schedule),
      team_(team),
      smoothing_steps_(options.smoothing_steps > 0
                           ? options.smoothing_steps
                           : smoothing_steps(discretization)),
      coarsest_(std::make_unique<Coarsest>()) {
  const int coarse = options.coarse_degree > 0 ? options.coarse_degree
                                               : coarse_degree(discretization);
  const auto lame = lame_constants<3>(material);
  const NodeTable* nodes = &fine;
  std::vector<int> level_held = held;
  while (nodes->degree > coarse) {
    auto level = std::make_unique<Level>();
    if (nodes != &fine) {
      level->own_nodes = std::move(coarsest_->nodes);
      nodes = &level->own_nodes;
      level->residual = std::make_unique<LaneVector<float>>(nodes->nodes);
      level->solution = std::make_unique<LaneVector<float>>(nodes->nodes);
    }
    level->nodes = nodes;
    level->held = level_held;
    level->stiffness = std::make_unique<MatrixFreeOperator<float>>(
        discretization, schedule, *nodes, nodes->degree + 1, lame, level->held,
        team, place);
    level->inverse_blocks =
        inverse_blocks(level->stiffness->diagonal(), level->held);
    level->step = std::make_unique<LaneVector<float>>(nodes->nodes);
    level->change = std::make_unique<LaneVector<float>>(nodes->nodes);
    level->largest_eigenvalue = largest_eigenvalue(*level);
    const int next = lanes::coarser_degree(nodes->degree);
    const Eigen::MatrixXd weight = interpolation(nodes->degree, next);
    for (Eigen::Index i = 0; i < weight.rows(); ++i) {
      for (Eigen::Index j = 0; j < weight.cols(); ++j) {
        level->interpolation.push_back(static_cast<float>(weight(i, j)));
      }
    }
    coarsest_->nodes = coarsen(*nodes, schedule, next);
    level_held =
        coarse_held(*nodes, level->held, coarsest_->nodes, schedule.cells());
    levels_.push_back(std::move(level));
    nodes = &coarsest_->nodes;
  }
  const auto assembled =
      coarse_discretization(discretization, schedule, coarsest_->nodes);
  coarsest_->numbers = number_equations(assembled.dofs(), level_held);
  coarsest_->factor = std::make_unique<SparseCholesky>(
      free_equations(assemble_stiffness(assembled, material, place),
                     coarsest_->numbers),
      place);
  coarsest_->residual = std::make_unique<LaneVector<float>>(nodes->nodes);
  coarsest_->solution = std::make_unique<LaneVector<float>>(nodes->nodes);
}

PMultigrid::~PMultigrid() = default;

void PMultigrid::apply(LaneVector<float>& residual,
                       LaneVector<float>& solution) {
  cycle(0, residual, solution);
}

void PMultigrid::cycle(std::size_t at, LaneVector<float>& residual,
                       LaneVector<float>& solution) {
  Level& level = *levels_[at];
  smooth(level, residual, solution, true);
  level.stiffness->apply(*level.step, *level.change);
  subtract(level, residual);
  const bool last = at + 1 == levels_.size();
  Level* next = last ? nullptr : levels_[at + 1].get();
  const NodeTable& coarse = last ? coarsest_->nodes : *next->nodes;
  LaneVector<float>& coarse_residual =
      last ? *coarsest_->residual : *next->residual;
  LaneVector<float>& correction = last ? *coarsest_->solution : *next->solution;
  restrict_to(level, residual, coarse, coarse_residual);
  if (last) {
    coarsest_->solve();
  } else {
    for (int dof : next->held) {
      std::fill_n(coarse_residual.at(dof / 3, dof % 3), kLanes, 0.0F);
    }
    cycle(at + 1, coarse_residual, correction);
  }
  prolong(level, correction, coarse);
  for (int dof : level.held) {
    std::fill_n(level.step->at(dof / 3, dof % 3), kLanes, 0.0F);
  }
  level.stiffness->apply(*level.step, *level.change);
  // The correction joins the solution with the first step of the smoother.
  smooth(level, residual, solution, false);
}

/// Before the coarse correction (`fresh`) the solution is zero; after it the
/// correction is in `step` and K times it in `change`.
void PMultigrid::smooth(Level& level, LaneVector<float>& residual,
                        LaneVector<float>& solution, bool fresh) {
  const auto& kernels = lane_kernels();
  const double lambda = level.largest_eigenvalue;
  for (int k = 0; k < smoothing_steps_; ++k) {
    lanes::SmoothArguments arguments;
    arguments.blocks = level.inverse_blocks.data();
    arguments.residual = residual.data();
    arguments.step = level.step->data();
    arguments.solution = solution.data();
    arguments.gain =
        static_cast<float>((8.0 * k + 4.0) / ((2.0 * k + 3.0) * lambda));
    if (k > 0) {
      level.stiffness->apply(*level.step, *level.change);
      arguments.keep = static_cast<float>((2.0 * k - 1.0) / (2.0 * k + 3.0));
    }
    arguments.fresh = fresh && k == 0;
    arguments.add_old = !fresh && k == 0;
    arguments.change = arguments.fresh ? nullptr : level.change->data();
    const auto& starts = level.nodes->part_start;
    team_.run(static_cast<int>(starts.size()) - 1, [&](int part) {
      auto here = arguments;
      here.begin = starts[static_cast<std::size_t>(part)];
      here.end = starts[static_cast<std::size_t>(part) + 1];
      kernels.smooth(here);
    });
  }
}

void PMultigrid::subtract(Level& level, LaneVector<float>& residual) {
  const auto& starts = level.nodes->part_start;
  team_.run(static_cast<int>(starts.size()) - 1, [&](int part) {
    lanes::SmoothArguments arguments;
    arguments.begin = starts[static_cast<std::size_t>(part)];
    arguments.end = starts[static_cast<std::size_t>(part) + 1];
    arguments.residual = residual.data();
    arguments.change = level.change->data();
    lane_kernels().subtract(arguments);
  });
}

void PMultigrid::restrict_to(Level& level, const LaneVector<float>& residual,
                             const NodeTable& coarse,
                             LaneVector<float>& target) {
  LaneVector<float> ghost(static_cast<int>(coarse.ghosts.size()));
  lanes::TransferArguments arguments;
  arguments.fine_scatter = level.nodes->scatter.data();
  arguments.fine_nodes = level.nodes->nodes;
  arguments.coarse_scatter = coarse.scatter.data();
  arguments.coarse_nodes = coarse.nodes;
  arguments.interpolation = level.interpolation.data();
  arguments.source = residual.data();
  arguments.target = target.data();
  arguments.ghost = ghost.data();
  const auto row = static_cast<std::size_t>(level.nodes->degree - 1);
  team_.run(schedule_.parts(), [&](int part) {
    auto here = arguments;
    here.begin = schedule_.part_start[static_cast<std::size_t>(part)];
    here.end = schedule_.part_start[static_cast<std::size_t>(part) + 1];
    lane_kernels().restrict_to[row](here);
  });
  add_ghosts(coarse, ghost, team_, target);
}

void PMultigrid::prolong(Level& level, const LaneVector<float>& source,
                         const NodeTable& coarse) {
  lanes::TransferArguments arguments;
  arguments.fine_scatter = level.nodes->scatter.data();
  arguments.fine_nodes = level.nodes->nodes;
  arguments.coarse_gather = coarse.gather.data();
  arguments.coarse_nodes = coarse.nodes;
  arguments.interpolation = level.interpolation.data();
  arguments.source = source.data();
  arguments.target = level.step->data();
  const auto row = static_cast<std::size_t>(level.nodes->degree - 1);
  team_.run(schedule_.parts(), [&](int part) {
    auto here = arguments;
    here.begin = schedule_.part_start[static_cast<std::size_t>(part)];
    here.end = schedule_.part_start[static_cast<std::size_t>(part) + 1];
    lane_kernels().prolong[row](here);
  });
}

double PMultigrid::largest_eigenvalue(Level& level) {
  // Lanczos through conjugate gradients from kLanes random vectors.
  constexpr int kSteps = 10;
  constexpr double kSafety = 1.1;
  const int nodes = level.nodes->nodes;
  LaneVector<float> r(nodes);
  LaneVector<float> z(nodes);
  LaneVector<float>& p = *level.step;
  LaneVector<float>& kp = *level.change;
  const auto size = static_cast<std::size_t>(nodes) * lanes::kNode<float>;
  for (std::size_t i = 0; i < size; ++i) r.data()[i] = noise(i);
  for (int dof : level.held) std::fill_n(r.at(dof / 3, dof % 3), kLanes, 0.0F);
  std::fill_n(p.data(), size, 0.0F);
  Eigen::Array<double, kLanes, kSteps> diagonal, beside;
  LaneSums rz = LaneSums::Ones();
  LaneSums first = rz;
  LaneSums alpha = LaneSums::Ones();
  int steps = 0;
  for (int step = 0; step < kSteps; ++step) {
    lanes::SmoothArguments jacobi;
    jacobi.end = nodes;
    jacobi.blocks = level.inverse_blocks.data();
    jacobi.gain = 1.0F;
    jacobi.fresh = true;
    jacobi.residual = r.data();
    jacobi.step = kp.data();
    jacobi.solution = z.data();
    lane_kernels().smooth(jacobi);
    const LaneSums before = rz;
    rz = dot(r, z);
    if (step == 0) first = rz;
    if (!(rz > 1e-10 * first).all()) break;  // a small matrix is exhausted
    ++steps;
    const LaneSums beta = step == 0 ? LaneSums::Zero().eval() : rz / before;
    combine(LaneSums::Ones(), z, beta, p);
    level.stiffness->apply(p, kp);
    diagonal.col(step) = beta / alpha;
    beside.col(step) = beta.sqrt() / alpha;  // between step − 1 and step
    alpha = rz / dot(p, kp);
    diagonal.col(step) += 1.0 / alpha;
    combine(-alpha, kp, LaneSums::Ones(), r);
  }
  double largest = 0.0;
  for (int lane = 0; lane < kLanes; ++lane) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
    eigen.computeFromTridiagonal(
        diagonal.row(lane).head(steps).matrix().transpose(),
        beside.row(lane).segment(1, steps - 1).matrix().transpose(),
        Eigen::EigenvaluesOnly);
    largest = std::max(largest, eigen.eigenvalues().maxCoeff());
  }
  return kSafety * largest;
}

std::vector<double> PMultigrid::largest_eigenvalues() const {
  std::vector<double> result;
  for (const auto& level : levels_) result.push_back(level->largest_eigenvalue);
  return result;
}

double PMultigrid::coarse_seconds() const {
  return coarsest_->seconds;
}

}  // namespace clevis::elasticity
