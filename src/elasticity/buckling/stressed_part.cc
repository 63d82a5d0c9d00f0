#include "elasticity/buckling/stressed_part.h"

#include <utility>

#include "elasticity/assembly/supports.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/problem/refinement.h"
#include "elasticity/problem/self_checks.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

constexpr double kCompressionTolerance = 1e-4;

std::unique_ptr<EnergyCoordinates> coordinates_of(
    const BucklingProblem& problem) {
  if (problem.plane != nullptr && problem.foundations.empty()) {
    return plate_coordinates(*problem.plane, problem.discretization,
                             problem.material, problem.fixed, problem.name);
  }
  return solid_coordinates(problem.discretization, problem.material,
                           {problem.fixed, problem.foundations}, problem.name);
}

}  // namespace

StressedPart::StressedPart(const BucklingProblem& problem)
    : problem_(problem),
      part_(problem.discretization),
      coordinates_(coordinates_of(problem)),
      pairs_(node_pairs(part_.cell_nodes, part_.nodes)) {
  const bool is_free = problem.fixed.empty() && problem.foundations.empty();
  const double density = problem.material.density;
  LoadBasis loads = load_columns(part_, problem.history, density, problem.name);
  if (is_free) {
    SolveChecks checks;
    balance_free_part<3>(part_, node_positions(part_), density, loads, checks);
  }
  loads = compress(loads, kCompressionTolerance);
  coefficients_ = loads.coefficients;
  loaded_ = coordinates_->of_loads(loads.columns);
  stress_ = std::make_unique<InitialStress>(
      part_, problem.material, coordinates_->displacements(loaded_));
  if (!is_free) return;
  for (const auto& groups : problem.holds) holds_.emplace_back(part_, groups);
}

MatrixXd StressedPart::shapes(const MatrixXd& unknowns,
                              std::size_t hold) const {
  MatrixXd u = coordinates_->displacements(unknowns);
  return holds_.empty() ? u : holds_[hold].project(u);
}

MatrixXd StressedPart::rotations() const {
  return holds_.empty() ? MatrixXd(part_.dofs(), 0)
                        : holds_[0].rigid().rightCols<3>();
}

MatrixXd StressedPart::broken_rotations(const MatrixXd& u,
                                        std::size_t hold) const {
  return holds_.empty() ? MatrixXd(0, u.cols())
                        : holds_[hold].broken(u).bottomRows<3>();
}

MatrixXd StressedPart::unknowns(const MatrixXd& u) const {
  return coordinates_->of_loads(forces_by_strain(part_, problem_.material, u));
}

MatrixXd StressedPart::answer(const MatrixXd& forces, std::size_t hold) const {
  return coordinates_->of_loads(holds_.empty() ? forces
                                               : holds_[hold].balance(forces));
}

dynamics::SelfAdjoint StressedPart::answer_to(const MassMatrix& matrix,
                                              double sign,
                                              std::size_t hold) const {
  return {equations(),
          [](const MatrixXd& y) {
            return y;
          },
          [this, &matrix, sign, hold](const MatrixXd& y, const MatrixXd&) {
            return answer(sign * multiply(matrix, shapes(y, hold)), hold);
          }};
}

}  // namespace clevis::elasticity
