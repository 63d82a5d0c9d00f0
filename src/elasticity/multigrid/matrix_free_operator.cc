#include "elasticity/multigrid/matrix_free_operator.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <type_traits>

#include <Eigen/LU>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/system/instruction_set.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;

template <typename Real>
std::vector<Real> row_major(const Eigen::MatrixXd& matrix) {
  std::vector<Real> entries;
  for (Index i = 0; i < matrix.rows(); ++i) {
    for (Index j = 0; j < matrix.cols(); ++j) {
      entries.push_back(static_cast<Real>(matrix(i, j)));
    }
  }
  return entries;
}

/// A task per part of the schedule.
template <typename Body>
void for_parts(ThreadTeam& team, const CellSchedule& schedule, Body&& body) {
  team.run(schedule.parts(), [&](int part) {
    const auto p = static_cast<std::size_t>(part);
    body(p, schedule.part_start[p], schedule.part_start[p + 1]);
  });
}

/// J^-1 and det J w of all cells at the points of a Gauss rule.
/// @return the least place in the schedule of a cell that folds, or none.
template <typename Real>
int fill_metric(const Discretization<3>& discretization,
                const CellSchedule& schedule, const mesh::Quadrature& rule,
                ThreadTeam& team, std::vector<Real>& metric) {
  const auto geometry = mesh::lagrange(
      mesh::gauss_lobatto(discretization.geometry_degree), rule.points);
  const Index q = rule.points.size();
  const auto cell_size = static_cast<std::size_t>(q * q * q) * lanes::kMetric;
  metric.resize(cell_size * schedule.cell.size());
  std::vector<int> folded(static_cast<std::size_t>(schedule.parts()),
                          std::numeric_limits<int>::max());
  for_parts(team, schedule, [&](std::size_t part, int begin, int end) {
    for (int place = begin; place < end; ++place) {
      const auto at = static_cast<std::size_t>(place);
      const auto cell = static_cast<std::size_t>(schedule.cell[at]);
      const auto grid = mesh::map_grid<3>(discretization.cell_points[cell],
                                          {&geometry, &geometry, &geometry});
      Real* to = metric.data() + cell_size * at;
      for (Index point = 0; point < q * q * q; ++point) {
        const Eigen::Matrix3d jacobian = grid.jacobian(point);
        const double determinant = jacobian.determinant();
        if (!(determinant > 0.0)) folded[part] = std::min(folded[part], place);
        const Eigen::Matrix3d inverse = jacobian.inverse();
        for (int a = 0; a < 3; ++a) {
          for (int d = 0; d < 3; ++d) {
            *to++ = static_cast<Real>(inverse(a, d));
          }
        }
        *to++ = static_cast<Real>(determinant * rule.weights[point % q] *
                                  rule.weights[point / q % q] *
                                  rule.weights[point / (q * q)]);
      }
    }
  });
  return *std::ranges::min_element(folded);
}

}  // namespace

const lanes::Kernels& lane_kernels() {
  static const lanes::Kernels kernels = [] {
    lanes::Kernels result;
#if defined(__x86_64__)
    switch (instruction_set()) {
      case InstructionSet::kAvx512:
        lanes::avx512::get(result);
        return result;
      case InstructionSet::kAvx2:
        lanes::avx2::get(result);
        return result;
      case InstructionSet::kPlain:
        break;
    }
#endif
    lanes::plain::get(result);
    return result;
  }();
  return kernels;
}

template <typename Real>
MatrixFreeOperator<Real>::MatrixFreeOperator(
    const Discretization<3>& discretization, const CellSchedule& schedule,
    const NodeTable& nodes, int points, const LameConstants<3>& lame,
    std::vector<int> held, ThreadTeam& team, const std::string& place)
    : schedule_(schedule),
      nodes_(nodes),
      team_(team),
      points_(points),
      lame_(lame),
      held_(std::move(held)),
      ghost_(static_cast<int>(nodes.ghosts.size())) {
  const auto rule = mesh::gauss(points);
  interpolation_ = row_major<Real>(
      mesh::lagrange(mesh::gauss_lobatto(nodes.degree), rule.points).value);
  derivative_ = row_major<Real>(mesh::lagrange(rule.points, rule.points).slope);
  const int folded = fill_metric(discretization, schedule, rule, team, metric_);
  if (folded == std::numeric_limits<int>::max()) return;
  throw Error("M005", place,
              fmt::format("cell {} folds when its geometry is interpolated "
                          "with degree {}",
                          schedule.cell[static_cast<std::size_t>(folded)],
                          discretization.geometry_degree),
              "Mesh the place finer.");
}

template <typename Real>
void MatrixFreeOperator<Real>::apply(const LaneVector<Real>& x,
                                     LaneVector<Real>& y) const {
  apply_to_all(x, y);
  for (int dof : held_) {
    std::fill_n(y.at(dof / 3, dof % 3), LaneVector<Real>::kLanes, Real{});
  }
}

template <typename Real>
void MatrixFreeOperator<Real>::apply_to_all(const LaneVector<Real>& x,
                                            LaneVector<Real>& y) const {
  const auto& kernels = lane_kernels();
  const auto row = static_cast<std::size_t>(nodes_.degree - 1);
  const auto column = static_cast<std::size_t>(points_ - nodes_.degree - 1);
  for_parts(team_, schedule_, [&](std::size_t, int begin, int end) {
    lanes::ApplyArguments<Real> arguments;
    arguments.begin = begin;
    arguments.end = end;
    arguments.gather = nodes_.gather.data();
    arguments.scatter = nodes_.scatter.data();
    arguments.metric = metric_.data();
    arguments.interpolation = interpolation_.data();
    arguments.derivative = derivative_.data();
    arguments.lambda = static_cast<Real>(lame_.lambda);
    arguments.mu = static_cast<Real>(lame_.mu);
    arguments.x = x.data();
    arguments.y = y.data();
    arguments.ghost = ghost_.data();
    arguments.nodes = nodes_.nodes;
    if constexpr (std::is_same_v<Real, double>) {
      kernels.apply_double[row][column](arguments);
    } else {
      kernels.apply_float[row][column](arguments);
    }
  });
  add_ghosts(nodes_, ghost_, team_, y);
}

template <typename Real>
std::vector<std::array<double, 6>> MatrixFreeOperator<Real>::diagonal() const {
  // ∫ ∇N_i ∇N_iᵀ dV of a cell for all its nodes i at a time.
  using Row = Eigen::Array<Real, Eigen::Dynamic, 1>;
  const auto rule = mesh::gauss(points_);
  const auto basis =
      mesh::lagrange(mesh::gauss_lobatto(nodes_.degree), rule.points);
  const Index n = nodes_.degree + 1;
  const Index q = points_;
  std::vector<std::array<Row, 3>> slopes;  // per point and direction
  for (Index point = 0; point < q * q * q; ++point) {
    const std::array<Index, 3> at{point % q, point / q % q, point / (q * q)};
    auto& slope = slopes.emplace_back();
    for (std::size_t d = 0; d < 3; ++d) {
      slope[d].resize(n * n * n);
      for (Index i = 0; i < n * n * n; ++i) {
        const std::array<Index, 3> node{i % n, i / n % n, i / (n * n)};
        double value = 1.0;
        for (std::size_t e = 0; e < 3; ++e) {
          const auto& table = e == d ? basis.slope : basis.value;
          value *= table(at[e], node[e]);
        }
        slope[d][i] = static_cast<Real>(value);
      }
    }
  }
  const auto places =
      static_cast<std::size_t>(nodes_.nodes) + nodes_.ghosts.size();
  std::vector<std::array<double, 6>> blocks(places);
  for_parts(team_, schedule_, [&](std::size_t, int begin, int end) {
    std::array<Row, 6> sums;
    std::array<Row, 3> g;
    for (int cell = begin; cell < end; ++cell) {
      for (Row& sum : sums) sum = Row::Zero(n * n * n);
      const Real* m = metric_.data() +
                      static_cast<Index>(cell) * q * q * q * lanes::kMetric;
      for (const auto& slope : slopes) {
        for (std::size_t d = 0; d < 3; ++d) {
          g[d] = slope[0] * m[d] + slope[1] * m[3 + d] + slope[2] * m[6 + d];
        }
        for (std::size_t a = 0, k = 0; a < 3; ++a) {
          for (std::size_t b = a; b < 3; ++b) sums[k++] += m[9] * g[a] * g[b];
        }
        m += lanes::kMetric;
      }
      const int* codes =
          nodes_.scatter.data() + static_cast<std::ptrdiff_t>(cell) * n * n * n;
      for (Index i = 0; i < n * n * n; ++i) {
        const int at = codes[i] < 0 ? ~codes[i] : codes[i];
        for (std::size_t k = 0; k < 6; ++k) {
          blocks[static_cast<std::size_t>(at)][k] +=
              static_cast<double>(sums[k][i]);
        }
      }
    }
  });
  for (const auto& [node, ghost] : nodes_.ghosts) {
    for (std::size_t k = 0; k < 6; ++k) {
      blocks[static_cast<std::size_t>(node)][k] +=
          blocks[static_cast<std::size_t>(nodes_.nodes + ghost)][k];
    }
  }
  blocks.resize(static_cast<std::size_t>(nodes_.nodes));
  // (λ + μ) G + μ tr(G) I.
  for (auto& block : blocks) {
    const double trace = lame_.mu * (block[0] + block[3] + block[5]);
    for (double& entry : block) entry *= lame_.lambda + lame_.mu;
    for (std::size_t k : {0U, 3U, 5U}) block[k] += trace;
  }
  return blocks;
}

template <typename Real>
double MatrixFreeOperator<Real>::traffic() const {
  const double vectors = 3.0 * sizeof(Real) * lanes::kNode<Real> * nodes_.nodes;
  const double numbers =
      sizeof(int) *
      static_cast<double>(nodes_.gather.size() + nodes_.scatter.size());
  return vectors + numbers + sizeof(Real) * static_cast<double>(metric_.size());
}

template <typename Real>
void add_ghosts(const NodeTable& nodes, const LaneVector<Real>& ghost,
                ThreadTeam& team, LaneVector<Real>& y) {
  const auto parts = static_cast<int>(nodes.ghost_start.size()) - 1;
  team.run(parts, [&](int part) {
    const auto p = static_cast<std::size_t>(part);
    for (int k = nodes.ghost_start[p]; k < nodes.ghost_start[p + 1]; ++k) {
      const auto [node, place] = nodes.ghosts[static_cast<std::size_t>(k)];
      const Real* from = ghost.at(place, 0);
      Real* to = y.at(node, 0);
      for (int i = 0; i < lanes::kNode<Real>; ++i) to[i] += from[i];
    }
  });
}

template class MatrixFreeOperator<double>;
template class MatrixFreeOperator<float>;
template void add_ghosts(const NodeTable&, const LaneVector<double>&,
                         ThreadTeam&, LaneVector<double>&);
template void add_ghosts(const NodeTable&, const LaneVector<float>&,
                         ThreadTeam&, LaneVector<float>&);

}  // namespace clevis::elasticity
