#include "elasticity/vibration/load_vibration.h"

#include "base/messages/errors.h"
#include "dynamics/systems/block_krylov.h"
#include "dynamics/systems/held_system.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/algebra/principal_columns.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/solid/solid_solve.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kSame = 0.02;  // of the energy norm
constexpr Index kMost = 12;

/// Reactions that equilibrium leaves open are shared by the joints' compliance;
/// the part's own would share them otherwise. Its answers then bend it where
/// the mechanism holds it.
/// @param answers  without rigid motion.
/// @throws Error F008.
void require_held(const dynamics::LinearSystem& system, const MatrixXd& answers,
                  const std::string& place) {
  constexpr double kMuch = 0.1;  // of the energy norm
  const double shift = system.least_shift();
  const auto forces = [&](const MatrixXd& x) -> MatrixXd {
    return system.stiffness(x) + shift * system.mass(x);
  };
  const auto energy = [&](const MatrixXd& x) {
    return x.cwiseProduct(forces(x)).sum();
  };
  const MatrixXd held = system.factor(shift)(forces(answers));
  if (energy(answers - held) < kMuch * kMuch * energy(answers)) return;
  throw Error("F008", place,
              "its joints hold it more than balance needs, and its reactions "
              "are shared as if it were rigid: no vibration goes with them",
              "Say links = \"elastic\" in [simulation], so that its own "
              "stiffness shares them, or free one of the joints.");
}

}  // namespace

template <int dim>
PartAtRest<dim> part_at_rest(const ElasticProblem<dim>& problem, int degree) {
  return {solve(problem, degree), supported_part(problem, degree)};
}

template <int dim>
MatrixXd LoadVibration<dim>::settled(MatrixXd answers) const {
  const Index own = answers.rows();
  answers.conservativeResize(own + part_.bodies, Eigen::NoChange);
  answers.bottomRows(part_.bodies).setZero();
  if (part_.held.cols() > 0) {
    answers = dynamics::moved_to_constraints(part_.free, part_.held, answers);
  }
  if (part_.sprung.cols() > 0) {
    // The loads have what springs do to a rigid part: they do not feel U.
    dynamics::LinearSystem loose = part_.free;
    if (part_.held.cols() > 0) {
      loose = dynamics::held_system(part_.free, part_.held);
    }
    if (loose.rigid.cols() > 0) {
      answers = dynamics::moved_to_constraints(loose, part_.sprung, answers);
    }
  }
  return answers;
}

template <int dim>
LoadVibration<dim>::LoadVibration(const PartAtRest<dim>& rest,
                                  const loads::LoadHistory& history,
                                  const std::string& name,
                                  const std::vector<Index>& driving,
                                  const std::vector<Index>& borne)
    : part_(held_by_mechanism(rest.part, history, name)),
      pins_(rest.part, history, borne, name) {
  const auto& system = part_.system;
  MatrixXd answers = settled(
      pins_.spread_evenly(restrict_rows(rest.statics.columns, part_.numbers),
                          rest.statics.coefficients));
  pressed_ = settled(pins_.differences());
  weighted_ = system.mass(answers);
  if (system.rigid.cols() > 0) {
    const MatrixXd rigid = dynamics::mass_orthonormal(system, system.rigid);
    answers -= product(rigid, transposed_product(rigid, weighted_));
  }
  const MatrixXd& coefficients = rest.statics.coefficients;
  MatrixXd at(coefficients.rows(), static_cast<Index>(driving.size()));
  for (Index i = 0; i < at.cols(); ++i) {
    at.col(i) = coefficients.col(driving[static_cast<std::size_t>(i)]);
  }
  const MatrixXd gram = transposed_product(answers, system.stiffness(answers));
  const MatrixXd combinations =
      principal_columns(0.5 * (gram + gram.transpose()), at, kSame, kMost)
          .combinations;
  driving_loads_ = combinations.cols();
  const MatrixXd start = product(answers, combinations);
  if (part_.held.cols() > 0) {
    require_held(system, start, "part " + name);
  }
  space_ = std::make_unique<dynamics::LoadShapes>(system, start);
}

template <int dim>
typename LoadVibration<dim>::Shapes LoadVibration<dim>::shapes(int count) {
  const auto found = space_->shapes(count);
  const auto along = [&](const MatrixXd& wrenches) -> MatrixXd {
    return transposed_product(wrenches, found.columns);
  };
  const MatrixXd sprung = along(part_.sprung), damped = along(part_.damped);
  const Eigen::VectorXd of_springs =
      sprung.colwise().squaredNorm().transpose().cwiseQuotient(found.squares);
  const Index own = found.columns.rows() - part_.bodies;
  MatrixXd of_part = found.columns.topRows(own);
  if (pressed_.cols() > 0) {
    of_part += product(MatrixXd(pressed_.topRows(own)),
                       pins_.reactions(of_part, found.squares));
  }
  return {
      extend_rows(of_part, part_.numbers), found.squares,
      transposed_product(found.columns, weighted_),
      Eigen::VectorXd::Ones(of_springs.size()) - of_springs,
      damped.rows() > 0 ? MatrixXd(damped.transpose() * damped) : MatrixXd()};
}

template PartAtRest<2> part_at_rest<2>(const ElasticProblem<2>&, int);
template PartAtRest<3> part_at_rest<3>(const ElasticProblem<3>&, int);
template class LoadVibration<2>;
template class LoadVibration<3>;

}  // namespace clevis::elasticity
