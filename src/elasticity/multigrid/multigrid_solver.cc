#include "elasticity/multigrid/multigrid_solver.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/values/stopwatch.h"
#include "elasticity/multigrid/block_cg.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int kLanes = lanes::kLanes<double>;

}  // namespace

struct MultigridSolver::Data {
  MultigridOptions options;
  ThreadTeam team;
  CellSchedule schedule;
  FineNodes nodes;
  std::vector<int> held;  // of the table's numbering
  std::unique_ptr<MatrixFreeOperator<double>> stiffness;
  std::unique_ptr<PMultigrid> multigrid;
  MultigridReport report;

  explicit Data(const MultigridOptions& wanted)
      : options(wanted), team(wanted.threads) {}

  /// Columns from `first` on into lanes, times their scale; zero beyond.
  void to_lanes(const MatrixXd& columns, Index first,
                const Eigen::VectorXd& scale, LaneVector<double>& lanes);
  void from_lanes(const LaneVector<double>& lanes, Index first,
                  const Eigen::VectorXd& scale, MatrixXd& columns);
};

void MultigridSolver::Data::to_lanes(const MatrixXd& columns, Index first,
                                     const Eigen::VectorXd& scale,
                                     LaneVector<double>& lanes) {
  const Index count = std::clamp<Index>(columns.cols() - first, 0, kLanes);
  team.run(64, [&](int task) {
    const auto size = static_cast<Index>(nodes.number.size());
    for (Index n = size * task / 64; n < size * (task + 1) / 64; ++n) {
      double* to = lanes.at(nodes.number[static_cast<std::size_t>(n)], 0);
      std::fill_n(to, lanes::kNode<double>, 0.0);
      for (int c = 0; c < 3; ++c) {
        for (Index lane = 0; lane < count; ++lane) {
          to[c * kLanes + lane] =
              columns(3 * n + c, first + lane) * scale[first + lane];
        }
      }
    }
  });
}

void MultigridSolver::Data::from_lanes(const LaneVector<double>& lanes,
                                       Index first,
                                       const Eigen::VectorXd& scale,
                                       MatrixXd& columns) {
  const Index count = std::clamp<Index>(columns.cols() - first, 0, kLanes);
  team.run(64, [&](int task) {
    const auto size = static_cast<Index>(nodes.number.size());
    for (Index n = size * task / 64; n < size * (task + 1) / 64; ++n) {
      const double* from =
          lanes.at(nodes.number[static_cast<std::size_t>(n)], 0);
      for (int c = 0; c < 3; ++c) {
        for (Index lane = 0; lane < count; ++lane) {
          columns(3 * n + c, first + lane) =
              from[c * kLanes + lane] * scale[first + lane];
        }
      }
    }
  });
}

MultigridSolver::MultigridSolver(const Discretization<3>& discretization,
                                 const part::Material& material,
                                 const std::vector<int>& held,
                                 const std::string& place,
                                 const MultigridOptions& options)
    : data_(std::make_unique<Data>(options)) {
  assert(discretization.shape == mesh::CellShape::kTensor);
  assert(discretization.thickness_degree == discretization.degree);
  Stopwatch watch;
  Data& d = *data_;
  d.schedule = schedule_cells(discretization);
  d.nodes = number_nodes(discretization, d.schedule);
  for (int dof : held) {
    d.held.push_back(3 * d.nodes.number[static_cast<std::size_t>(dof / 3)] +
                     dof % 3);
  }
  std::ranges::sort(d.held);
  // The assembled matrix's own quadrature.
  const int points =
      discretization.degree + (discretization.geometry_degree > 1 ? 2 : 1);
  d.stiffness = std::make_unique<MatrixFreeOperator<double>>(
      discretization, d.schedule, d.nodes.table, points,
      lame_constants<3>(material), d.held, d.team, place);
  d.multigrid = std::make_unique<PMultigrid>(discretization, material,
                                             d.schedule, d.nodes.table, d.held,
                                             options, d.team, place);
  d.report.setup_seconds = watch.lap();
}

MultigridSolver::~MultigridSolver() = default;

MatrixXd MultigridSolver::solve(const MatrixXd& loads) {
  Stopwatch watch;
  Data& d = *data_;
  const double coarse_before = d.multigrid->coarse_seconds();
  MatrixXd result(loads.rows(), loads.cols());
  Eigen::VectorXd norm(loads.cols());
  for (Index j = 0; j < loads.cols(); ++j) norm[j] = loads.col(j).norm();
  const Eigen::VectorXd scale =
      (norm.array() > 0.0).select(norm.cwiseInverse(), 0.0);
  const int count = d.nodes.table.nodes;
  BlockCg cg(*d.stiffness, *d.multigrid, d.nodes.table, d.team);
  std::array<LaneVector<double>, 2> right{LaneVector<double>(count),
                                          LaneVector<double>(count)};
  for (Index first = 0; first < loads.cols(); first += kBlockColumns) {
    const int blocks = loads.cols() - first > kLanes ? 2 : 1;
    for (int b = 0; b < blocks; ++b) {
      auto& lanes = right[static_cast<std::size_t>(b)];
      d.to_lanes(loads, first + b * kLanes, scale, lanes);
      for (int dof : d.held) {
        std::fill_n(lanes.at(dof / 3, dof % 3), kLanes, 0.0);
      }
    }
    d.report.iterations = std::max(
        d.report.iterations,
        cg.solve(right, blocks, d.options.tolerance, d.options.max_iterations));
    d.report.residual = std::max(d.report.residual, cg.residual().maxCoeff());
    for (int b = 0; b < blocks; ++b) {
      d.from_lanes(cg.x(b), first + b * kLanes, norm, result);
    }
  }
  d.report.solve_seconds += watch.lap();
  d.report.coarse_seconds += d.multigrid->coarse_seconds() - coarse_before;
  return result;
}

MatrixXd MultigridSolver::multiply(const MatrixXd& columns) const {
  Data& d = *data_;
  MatrixXd result(columns.rows(), columns.cols());
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(columns.cols());
  LaneVector<double> x(d.nodes.table.nodes);
  LaneVector<double> y(d.nodes.table.nodes);
  for (Index first = 0; first < columns.cols(); first += kLanes) {
    d.to_lanes(columns, first, one, x);
    d.stiffness->apply_to_all(x, y);
    d.from_lanes(y, first, one, result);
  }
  return result;
}

MatrixXd MultigridSolver::multiply_absolute_diagonal(
    const MatrixXd& columns) const {
  const Data& d = *data_;
  const auto blocks = d.stiffness->diagonal();
  MatrixXd result(columns.rows(), columns.cols());
  for (std::size_t node = 0; node < d.nodes.number.size(); ++node) {
    const auto& b = blocks[static_cast<std::size_t>(d.nodes.number[node])];
    const std::array<double, 3> diagonal{b[0], b[3], b[5]};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto row = static_cast<Index>(3 * node + c);
      result.row(row) = diagonal[c] * columns.row(row).cwiseAbs();
    }
  }
  return result;
}

const MultigridReport& MultigridSolver::report() const {
  return data_->report;
}

}  // namespace clevis::elasticity
