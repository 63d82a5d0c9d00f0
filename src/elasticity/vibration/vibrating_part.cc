#include "elasticity/vibration/vibrating_part.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/messages/errors.h"
#include "base/system/processor_share.h"
#include "dynamics/systems/attached_system.h"
#include "dynamics/systems/held_system.h"
#include "dynamics/systems/sprung_system.h"
#include "dynamics/systems/weighed_system.h"
#include "elasticity/algebra/symmetric_product.h"
#include "elasticity/assembly/mass_matrix.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/direct/front_tree.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/direct/memory_forecast.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/vibration/neighbour_hold.h"

namespace clevis::elasticity {
namespace {

using dynamics::BlockOperator;
using Eigen::Index;
using Eigen::MatrixXd;

/// Keeps the matrix alive.
BlockOperator product_with(std::shared_ptr<const UpperTriangle> upper) {
  return [upper](const MatrixXd& x) {
    return symmetric_product({1, upper->rows(), upper->row_start.data(),
                              upper->column.data(), upper->value.data()},
                             x);
  };
}

/// The factor of the last shift stays; the next one takes its memory.
std::function<BlockOperator(double)> last_kept(
    std::function<BlockOperator(double)> factor) {
  const auto last = std::make_shared<std::pair<double, BlockOperator>>();
  return [last, factor = std::move(factor)](double shift) {
    if (!last->second || last->first != shift) {
      last->second = nullptr;
      *last = {shift, factor(shift)};
    }
    return last->second;
  };
}

/// A square of a circular frequency that lies below the first elastic one of
/// bodies up to some hundred times as long as thick [1/s²].
double low_square(const part::Material& material, double size) {
  constexpr double kSlender = 0.03;
  const double per_second =
      kSlender * std::sqrt(material.youngs_modulus / material.density) / size;
  return per_second * per_second;
}

/// Springs beside dampers, too soft to count at any frequency of a link: bodies
/// that only dampers drag along have shapes of vibration so.
MatrixXd with_slow_springs(const MatrixXd& sprung, const MatrixXd& damped) {
  constexpr double kSlow = 0.1;  // stiffness over damping [1/s]
  MatrixXd all(damped.rows(), sprung.cols() + damped.cols());
  all << sprung, std::sqrt(kSlow) * damped;
  return all;
}

template <int dim>
void require_memory_for(const Discretization<dim>& discretization,
                        const Dissection& dissection,
                        const std::string& place) {
  // Two factors: a strike's step and its half.
  require_memory(2.0 * 8.0 * dissection.entries * dim * dim,
                 discretization.dofs(), usable_memory(), place);
}

}  // namespace

template <int dim>
VibratingPart<dim> supported_part(const ElasticProblem<dim>& problem,
                                  int degree) {
  const std::string place = "part " + problem.name;
  VibratingPart<dim> part;
  part.discretization = discretize(problem.mesh, degree);
  require_dofs(part.discretization.dofs(), problem.max_dofs, place);
  const auto positions = node_positions(part.discretization);
  std::vector<int> held;
  const FoundationStiffness<dim> bed(part.discretization, problem.foundations,
                                     problem.name);
  if (!problem.fixed.empty() || !bed.empty()) {
    held = fixed_supports(part.discretization, positions, problem.fixed, place,
                          &bed);
  }
  part.numbers = number_equations(part.discretization.dofs(), held);
  const auto dissection =
      std::make_shared<const Dissection>(dissect(part.discretization));
  require_memory_for(part.discretization, *dissection, place);
  auto stiffness =
      assemble_stiffness(part.discretization, problem.material, place);
  bed.add_to(stiffness);
  const auto mass =
      assemble_mass(part.discretization, stiffness, problem.material.density);
  for (std::size_t row = 0; row + 1 < mass.row_start.size(); ++row) {
    for (int k = mass.row_start[row]; k < mass.row_start[row + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const bool diagonal = mass.column[at] == static_cast<int>(row);
      part.mass += (diagonal ? 1.0 : 2.0) * mass.value[at];
    }
  }
  const auto k = std::make_shared<const UpperTriangle>(
      free_equations(stiffness, part.numbers));
  const auto m = std::make_shared<const UpperTriangle>(
      free_equations(mass, dim, part.numbers));
  part.system.size = part.numbers.count;
  part.system.stiffness = product_with(k);
  part.system.mass = product_with(m);
  part.system.factor =
      last_kept([k, m, dissection, place,
                 equation = part.numbers.equation](double shift) {
        const auto factor = std::make_shared<const FrontalCholesky>(
            shift == 0.0 ? *k : weighted_sum(*k, shift, *m),
            front_tree(*dissection, dim, equation), place, own_processors());
        return [factor](const MatrixXd& b) {
          return factor->solve(b);
        };
      });
  part.system.rigid.resize(part.system.size, 0);
  const Eigen::Matrix<double, dim, 1> low = positions.rowwise().minCoeff();
  const Eigen::Matrix<double, dim, 1> high = positions.rowwise().maxCoeff();
  const double size = (high - low).norm();
  part.system.low_square = low_square(problem.material, size);
  if (held.empty() && bed.empty()) {
    part.system.rigid = rigid_modes<dim>(positions, 0.5 * (low + high), size);
  }
  part.free = part.system;
  for (MatrixXd* none : {&part.held, &part.sprung, &part.damped}) {
    none->resize(part.system.size, 0);
  }
  return part;
}

template <int dim>
VibratingPart<dim> held_by_mechanism(VibratingPart<dim> part,
                                     const loads::LoadHistory& history,
                                     const std::string& part_name) {
  if (part.free.rigid.cols() == 0) return part;
  NeighbourHold hold = neighbour_hold(part.discretization, history, part_name);
  part.held = std::move(hold.held);
  part.damped = std::move(hold.damped);
  part.sprung = with_slow_springs(hold.sprung, part.damped);
  part.bodies = hold.bodies;
  if (part.bodies > 0) {
    part.free = dynamics::attached_system(part.free, part.bodies);
  }
  if (hold.weighed.cols() > 0) {
    part.free = dynamics::weighed_system(part.free, hold.weighed);
  }
  part.system = part.sprung.cols() > 0
                    ? dynamics::sprung_system(part.free, part.sprung)
                    : part.free;
  if (part.held.cols() > 0) {
    part.system = dynamics::held_system(part.system, part.held);
  }
  return part;
}

template <int dim>
VibratingPart<dim> vibrating_part(const ElasticProblem<dim>& problem,
                                  int degree) {
  return held_by_mechanism(supported_part(problem, degree), problem.history,
                           problem.name);
}

template <int dim>
Eigen::VectorXd unit_load(const VibratingPart<dim>& part,
                          const std::string& group,
                          const Eigen::Vector3d& direction,
                          const std::string& place) {
  const auto& discretization = part.discretization;
  const auto found = std::ranges::find(discretization.groups, group,
                                       &mesh::SurfaceGroup::name);
  if (found == discretization.groups.end() ||
      discretization
          .group_faces[static_cast<std::size_t>(found -
                                                discretization.groups.begin())]
          .empty()) {
    std::vector<std::string> names;
    for (const auto& known : discretization.groups) {
      names.push_back(known.name);
    }
    throw Error("M003", place,
                fmt::format("the mesh has no surface group \"{}\"", group),
                fmt::format("Groups of the mesh: {}.", fmt::join(names, ", ")));
  }
  FaceTables<dim> tables;
  const GroupTrace trace = group_trace(
      discretization, static_cast<int>(found - discretization.groups.begin()),
      tables);
  const double area = trace.quadrature.weights.sum();
  MatrixXd load = MatrixXd::Zero(discretization.dofs(), 1);
  Index begin = 0;
  for (const auto& face : trace.faces) {
    const Index n = face.values->rows();
    const Eigen::VectorXd nodal =
        face.values->transpose() * trace.quadrature.weights.segment(begin, n);
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      load.col(0).template segment<dim>(dim * face.nodes[i]) +=
          nodal[static_cast<Index>(i)] / area * direction.template head<dim>();
    }
    begin += n;
  }
  return restrict_rows(load, part.numbers);
}

#define CLEVIS_INSTANTIATE(dim)                                               \
  template VibratingPart<dim> supported_part<dim>(const ElasticProblem<dim>&, \
                                                  int);                       \
  template VibratingPart<dim> held_by_mechanism<dim>(                         \
      VibratingPart<dim>, const loads::LoadHistory&, const std::string&);     \
  template VibratingPart<dim> vibrating_part<dim>(const ElasticProblem<dim>&, \
                                                  int);                       \
  template Eigen::VectorXd unit_load<dim>(                                    \
      const VibratingPart<dim>&, const std::string&, const Eigen::Vector3d&,  \
      const std::string&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
