#include "elasticity/vibration/pin_reactions.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <Eigen/QR>

#include "base/algebra/append_columns.h"
#include "base/messages/errors.h"
#include "dynamics/systems/block_krylov.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/nodal_loads/seat_means.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using loads::Wrench;

/// Components of a wrench in space. Of the forces, which come first, reactions
/// settle with no number of shapes as loads jump.
constexpr Index kForces = 3, kMoments = 3, kComponents = kForces + kMoments;

/// Of the wrench's parts that press, a moment by an arm [N].
double size_of(const Wrench& wrench, double arm) {
  return wrench.force.norm() + wrench.moment.norm() / arm;
}

/// A bore's or journal's radius; nothing of a group on no cylinder.
template <int dim>
std::optional<double> radius_of(const Discretization<dim>& discretization,
                                const std::string& group) {
  for (const auto& known : discretization.groups) {
    if (known.name == group && known.cylinder) return known.cylinder->radius;
  }
  return std::nullopt;
}

/// The largest wrench of a seat at some instants; nothing where others bear a
/// thousand times as much.
const Wrench* largest_on(std::size_t seat, double radius,
                         const loads::LoadHistory& history,
                         const std::vector<Index>& instants) {
  constexpr double kLeast = 1e-3;
  const Wrench* largest = nullptr;
  double most = 0.0, most_of_all = 0.0;
  for (const Index i : instants) {
    const auto& wrenches =
        history.instants[static_cast<std::size_t>(i)].wrenches;
    for (const Wrench& wrench : wrenches) {
      most_of_all = std::max(most_of_all, size_of(wrench, radius));
    }
    const double size = size_of(wrenches[seat], radius);
    if (size > most) {
      most = size;
      largest = &wrenches[seat];
    }
  }
  return most > kLeast * most_of_all ? largest : nullptr;
}

/// Derivative of a pin's pressure by its moment, dofs × components [1/m];
/// nothing where it would have to pull at an open wall.
template <int dim>
std::optional<MatrixXd> pressure_derivative(
    const Discretization<dim>& discretization, const loads::Seat& seat,
    const Wrench& wrench, double radius, const std::string& part_name) {
  constexpr double kStep = 1e-4;  // of the wrench
  const double step = kStep * size_of(wrench, radius) * radius;
  loads::LoadHistory stepped{.seats = {seat}};
  stepped.instants.push_back({.wrenches = {wrench}});
  for (Index k = 0; k < kMoments; ++k) {
    Wrench next = wrench;
    next.moment[k] += step;
    stepped.instants.push_back({.wrenches = {next}});
  }
  try {
    const MatrixXd all =
        assemble_loads(discretization, stepped, 0.0, part_name);
    return (all.rightCols(kMoments).colwise() - all.col(0)) / step;
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Motions of least strain that move one seat by one, in one direction of its
/// mean, and the others not: Cᵀ ψ = 1.
/// @param means  C, equations × directions. @param answers  to them, without
/// rigid motion.
MatrixXd moved_by_ones(const MatrixXd& means, const MatrixXd& answers,
                       const MatrixXd& rigid) {
  const Index seats = means.cols(), motions = rigid.cols();
  const VectorXd unit =
      means.cwiseProduct(answers).colwise().sum().cwiseSqrt().cwiseInverse();
  const MatrixXd give = unit.asDiagonal() * transposed_product(means, answers) *
                        unit.asDiagonal();
  const MatrixXd felt = unit.asDiagonal() * transposed_product(means, rigid);
  const double size = felt.norm();
  MatrixXd balance = MatrixXd::Zero(seats + motions, seats + motions);
  balance.topLeftCorner(seats, seats) = give;
  balance.topRightCorner(seats, motions) = felt / size;
  balance.bottomLeftCorner(motions, seats) = felt.transpose() / size;
  MatrixXd wanted = MatrixXd::Zero(seats + motions, seats);
  wanted.topRows(seats) = unit.asDiagonal();
  const MatrixXd found =
      balance.completeOrthogonalDecomposition().solve(wanted);
  return product(answers, unit.asDiagonal() * found.topRows(seats)) +
         product(rigid, found.bottomRows(motions) / size);
}

/// Moments of the seats, × instants [N m]. @param rows  of all seats'
/// components.
MatrixXd moments_at(const std::vector<loads::InstantLoad>& instants,
                    const std::vector<Index>& rows) {
  MatrixXd found(std::ssize(rows), std::ssize(instants));
  for (Index i = 0; i < found.cols(); ++i) {
    for (Index k = 0; k < found.rows(); ++k) {
      const Index row = rows[static_cast<std::size_t>(k)];
      const Wrench& wrench =
          instants[static_cast<std::size_t>(i)]
              .wrenches[static_cast<std::size_t>(row / kComponents)];
      found(k, i) = wrench.moment[row % kComponents - kForces];
    }
  }
  return found;
}

}  // namespace

template <int dim>
PinReactions<dim>::PinReactions(const VibratingPart<dim>& part,
                                const loads::LoadHistory& history,
                                const std::vector<Index>& instants,
                                const std::string& part_name) {
  const Discretization<dim>& discretization = part.discretization;
  const dynamics::LinearSystem& system = part.system;
  for (MatrixXd* none : {&differences_, &stiffness_, &mass_}) {
    none->resize(system.size, 0);
  }
  if (dim == 2 || !history.hold || system.rigid.cols() == 0) return;
  const MatrixXd means =
      seat_means(discretization, history.seats,
                 history.hold_that_counts().zones, part_name);
  MatrixXd forces(means.rows(), 0);
  std::vector<Index> pressed;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    const loads::Seat& seat = history.seats[s];
    const auto radius = radius_of(discretization, seat.group);
    if (seat.kind != loads::SeatKind::kBearing || seat.slide || !radius) {
      continue;
    }
    const Wrench* largest = largest_on(s, *radius, history, instants);
    if (largest == nullptr) continue;
    const auto pressure =
        pressure_derivative(discretization, seat, *largest, *radius, part_name);
    if (!pressure) continue;
    const Index begin = kComponents * static_cast<Index>(s) + kForces;
    append_columns(*pressure - means.middleCols(begin, kMoments), forces);
    for (Index k = 0; k < kMoments; ++k) pressed.push_back(begin + k);
  }
  if (pressed.empty()) return;
  moments_ = moments_at(history.instants, pressed);
  const MatrixXd rigid = dynamics::mass_orthonormal(system, system.rigid);
  const MatrixXd weighted = system.mass(rigid);
  const double shift = system.least_shift();
  const auto solve = system.factor(shift);
  const auto elastic = [&](const MatrixXd& b) -> MatrixXd {
    const MatrixXd x =
        solve(b - product(weighted, transposed_product(rigid, b)));
    return x - product(rigid, transposed_product(weighted, x));
  };
  const MatrixXd balanced = restrict_rows(forces, part.numbers);
  // (K + s M)⁻¹ for K⁻¹: what is missing falls by s/ω² a step, and the forces
  // are felt beside the seats, where ω² is large.
  differences_ = elastic(balanced);
  differences_ = elastic(balanced + shift * system.mass(differences_));

  const MatrixXd reduced = restrict_rows(means, part.numbers);
  const MatrixXd moved = moved_by_ones(reduced, elastic(reduced), rigid);
  const MatrixXd ones = moved(Eigen::all, pressed);
  stiffness_ = system.stiffness(ones);
  mass_ = system.mass(ones);
}

template <int dim>
MatrixXd PinReactions<dim>::reactions(const MatrixXd& shapes,
                                      const VectorXd& squares) const {
  return transposed_product(stiffness_, shapes) -
         transposed_product(mass_, shapes) * squares.asDiagonal();
}

template <int dim>
MatrixXd PinReactions<dim>::spread_evenly(const MatrixXd& answers,
                                          const MatrixXd& coefficients) const {
  if (differences_.cols() == 0) return answers;
  const MatrixXd of_columns = MatrixXd(coefficients.transpose())
                                  .completeOrthogonalDecomposition()
                                  .solve(moments_.transpose())
                                  .transpose();
  return answers - product(differences_, of_columns);
}

template class PinReactions<2>;
template class PinReactions<3>;

}  // namespace clevis::elasticity
