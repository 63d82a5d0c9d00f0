#include "elasticity/buckling/stressed_part.h"

#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/problem/refinement.h"
#include "elasticity/problem/self_checks.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

constexpr double kCompressionTolerance = 1e-4;

/// Columns that span the same, orthonormal.
MatrixXd span_of(const MatrixXd& columns) {
  constexpr double kDependent = 1e-6;
  if (columns.cols() == 0) return columns;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(
      transposed_product(columns, columns));
  const Eigen::VectorXd& squares = gram.eigenvalues();
  const Eigen::Index n =
      (squares.array() > kDependent * squares[squares.size() - 1]).count();
  return product(columns,
                 gram.eigenvectors().rightCols(n) *
                     squares.tail(n).cwiseSqrt().cwiseInverse().asDiagonal());
}

}  // namespace

std::shared_ptr<const EnergyCoordinates> energy_coordinates(
    const BucklingProblem& problem) {
  if (problem.plane != nullptr && problem.foundations.empty()) {
    return plate_coordinates(*problem.plane, problem.discretization,
                             problem.material, problem.fixed, problem.name);
  }
  return solid_coordinates(problem.discretization, problem.material,
                           {problem.fixed, problem.foundations}, problem.name);
}

HeldPart::HeldPart(const BucklingProblem& problem)
    : problem_(problem),
      part_(problem.discretization),
      is_free_(problem.fixed.empty() && problem.foundations.empty()),
      coordinates_(problem.coordinates ? problem.coordinates
                                       : energy_coordinates(problem)),
      pairs_(node_pairs(part_.cell_nodes, part_.nodes)) {
  if (is_free_) {
    motions_ = std::make_unique<MeanMotions<3>>(part_);
    for (const HoldingSeats& hold : problem.holds) {
      holds_.emplace_back(*motions_, hold, problem.name);
      beyond_.push_back(
          span_of(coordinates_->of_loads(holds_.back().beyond())));
    }
  }
  if (beyond_.empty()) beyond_.emplace_back(equations(), 0);
}

MatrixXd HeldPart::held(const MatrixXd& u, std::size_t hold) const {
  return holds_.empty() ? u : holds_[hold].project(u);
}

MatrixXd HeldPart::displacements(const MatrixXd& unknowns,
                                 std::size_t hold) const {
  return held(coordinates_->displacements(unknowns), hold);
}

MatrixXd HeldPart::shapes(const MatrixXd& unknowns, std::size_t hold) const {
  return displacements(freed(unknowns, hold), hold);
}

MatrixXd HeldPart::freed(const MatrixXd& unknowns, std::size_t hold) const {
  const MatrixXd& beyond = beyond_[hold];
  if (beyond.cols() == 0) return unknowns;
  return unknowns - product(beyond, transposed_product(beyond, unknowns));
}

MatrixXd HeldPart::rigid() const {
  return motions_ ? motions_->rigid() : MatrixXd(part_.dofs(), 0);
}

MatrixXd HeldPart::broken(const MatrixXd& u, std::size_t hold) const {
  return holds_.empty() ? MatrixXd(0, u.cols()) : holds_[hold].broken(u);
}

MatrixXd HeldPart::unknowns(const MatrixXd& u) const {
  return coordinates_->of_loads(forces_by_strain(part_, problem_.material, u));
}

MatrixXd HeldPart::answer_in_balance(const MatrixXd& forces,
                                     std::size_t hold) const {
  return coordinates_->of_loads(holds_.empty() ? forces
                                               : holds_[hold].balance(forces));
}

MatrixXd HeldPart::answer(const MatrixXd& forces, std::size_t hold) const {
  return freed(answer_in_balance(forces, hold), hold);
}

dynamics::SelfAdjoint HeldPart::answer_to(
    std::function<MatrixXd(const MatrixXd&)> forces, std::size_t hold) const {
  return {equations(),
          [](const MatrixXd& y) {
            return y;
          },
          [this, forces = std::move(forces), hold](const MatrixXd& y,
                                                   const MatrixXd&) {
            return answer(forces(shapes(y, hold)), hold);
          }};
}

MassMatrix HeldPart::mass() const {
  const InitialStress none(part_, problem_.material, MatrixXd(part_.dofs(), 0));
  return none.mass(pairs_, problem_.material.density);
}

double HeldPart::lowest_frequency(std::size_t hold) const {
  constexpr int kMostSteps = 12;
  constexpr double kSettled = 1e-2;  // of the square
  constexpr Eigen::Index kBlock = 4;
  const MassMatrix matrix = mass();
  dynamics::BlockKrylov space(
      answer_to(
          [&](const MatrixXd& u) {
            return multiply(matrix, u);
          },
          hold),
      dynamics::random_block(equations(), std::min(kBlock, equations())), {});
  double theta = 0.0;
  for (int step = 0; step < kMostSteps && !space.is_closed(); ++step) {
    space.extend();
    const double before = theta;
    theta = space.ritz_values().theta[0];
    if (theta - before < kSettled * theta) break;
  }
  return 1.0 / std::sqrt(theta);
}

StressedPart::StressedPart(const BucklingProblem& problem, const HeldPart& part)
    : StressedPart(problem, part,
                   surface_loads<3>(problem.discretization, problem.history,
                                    problem.name)) {}

StressedPart::StressedPart(const BucklingProblem& problem, const HeldPart& part,
                           const std::vector<SurfaceLoads>& surfaces)
    : part_(part),
      highest_(problem.highest),
      pushes_(problem.discretization, problem.history, surfaces, problem.name) {
  const Discretization<3>& space = problem.discretization;
  const double density = problem.material.density;
  SplitLoads all = load_columns(space, problem.history, density, surfaces);
  if (part.is_free()) {
    SolveChecks checks;
    balance_free_part<3>(space, node_positions(space), density, all, checks);
  }
  const LoadBasis loads = compress(all, kCompressionTolerance);
  coefficients_ = loads.coefficients;
  loaded_ = part.coordinates().of_loads(loads.columns);
  displaced_ = part.coordinates().displacements(loaded_);
  stress_ =
      std::make_unique<InitialStress>(space, problem.material, displaced_);
}

std::function<MatrixXd(const MatrixXd&)> StressedPart::pushing(
    Eigen::Index instant) const {
  return [this,
          geometric =
              stress_->stiffness(part_.pairs(), coefficients_.col(instant)),
          gain = pushes_.gain(instant)](const MatrixXd& u) {
    MatrixXd forces = -multiply(geometric, u);
    pushes_.add(u, gain, forces);
    return forces;
  };
}

}  // namespace clevis::elasticity
