#include "elasticity/vibration/eigenmodes.h"

#include <cmath>
#include <numbers>

#include "dynamics/systems/eigenmodes.h"
#include "elasticity/nodal_loads/seat_means.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/vibration/vibrating_part.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

/// Unit displacement of all equations along each direction.
template <int dim>
MatrixXd uniform_displacements(const VibratingPart<dim>& part) {
  MatrixXd all = MatrixXd::Zero(part.discretization.dofs(), dim);
  for (int row = 0; row < all.rows(); ++row) all(row, row % dim) = 1.0;
  return restrict_rows(all, part.numbers);
}

}  // namespace

template <int dim>
Eigenmodes<dim> eigenmodes(const ElasticProblem<dim>& problem, int degree,
                           int count) {
  const auto part = vibrating_part(problem, degree);
  const auto modes =
      dynamics::lowest_modes(part.system, count, "part " + problem.name);
  Eigenmodes<dim> result;
  result.frequencies =
      modes.squares.cwiseMax(0.0).cwiseSqrt() / (2.0 * std::numbers::pi);
  result.shapes = extend_rows(modes.shapes, part.numbers);
  result.rigid = modes.rigid;
  result.participation =
      (modes.shapes.transpose() * part.system.mass(uniform_displacements(part)))
          .cwiseAbs2() /
      part.mass;
  result.residual = modes.residual;
  result.mass = part.mass;
  result.equations = part.numbers.count;
  result.discretization = part.discretization;
  return result;
}

template <int dim>
double FirstPeriods<dim>::at(double hold_time) {
  constexpr double kTolerance = 1e-3;  // the period to its square
  constexpr int kSmall = 60'000;       // equations
  if (!part_) part_ = supported_part(problem_, degree_);
  const bool is_small = part_->system.size < kSmall;
  loads::LoadHistory history = problem_.history;
  history.hold_time = hold_time;
  const auto part =
      held_by_mechanism(is_small ? *part_ : *std::exchange(part_, std::nullopt),
                        history, problem_.name);
  const auto rigid = static_cast<int>(part.system.rigid.cols());
  const auto modes = dynamics::lowest_modes(
      part.system, rigid + 1, "part " + problem_.name, kTolerance);
  return 2.0 * std::numbers::pi / std::sqrt(modes.squares[modes.rigid]);
}

template <int dim>
std::optional<SeatShapes> FirstPeriods<dim>::seat_shapes(
    const MatrixXd& wrenches, const std::vector<loads::Seat>& seats,
    const std::vector<loads::ContactZone>& zones,
    bool has_fields) requires(dim == 3) {
  if (!part_) part_ = supported_part(problem_, degree_);
  if (part_->free.rigid.cols() == 0) return std::nullopt;
  return SeatShapes(
      *part_, wrenches,
      seat_means(part_->discretization, seats, zones, problem_.name),
      has_fields);
}

template <int dim>
double period_along(const ElasticProblem<dim>& problem, int degree,
                    const Eigen::Vector3d& direction) {
  constexpr int kModes = 16;
  const auto modes = eigenmodes(problem, degree, kModes);
  Eigen::Index along = 0;
  (modes.participation * direction.head<dim>().cwiseAbs2()).maxCoeff(&along);
  return 1.0 / modes.frequencies[along];
}

template Eigenmodes<2> eigenmodes<2>(const ElasticProblem<2>&, int, int);
template Eigenmodes<3> eigenmodes<3>(const ElasticProblem<3>&, int, int);
template class FirstPeriods<2>;
template class FirstPeriods<3>;
template double period_along<2>(const ElasticProblem<2>&, int,
                                const Eigen::Vector3d&);
template double period_along<3>(const ElasticProblem<3>&, int,
                                const Eigen::Vector3d&);

}  // namespace clevis::elasticity
