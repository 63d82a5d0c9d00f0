#include "calculix/model.h"

#include <array>
#include <utility>

#include "calculix/determinate.h"
#include "calculix/node_reduction.h"
#include "elasticity/assembly/foundation.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/problem/elastic_problem.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/gmsh/gmsh_element.h"

namespace clevis::calculix {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using elasticity::Discretization;
using mesh::CellShape;
using mesh::PartMesh;

/// CalculiX's number of a local face of deal.II's.
constexpr std::array<int, 6> kHexahedronFace = {6, 4, 3, 5, 1, 2};
constexpr std::array<int, 4> kTetrahedronFace = {1, 2, 4, 3};

/// The hexahedra with the geometry of their 20 nodes, which lie where the
/// mesh's own geometry has them.
PartMesh<3> with_serendipity_geometry(const PartMesh<3>& mesh) {
  PartMesh<3> result = mesh;
  result.degree = 2;
  const MatrixXd to_three = mesh::lagrange(mesh::gauss_lobatto(mesh.degree),
                                           Eigen::Vector3d(0.0, 0.5, 1.0))
                                .value;
  const auto order = mesh::hexahedron_node_order(2);
  const MatrixXd complete = mesh::serendipity_to_complete();
  for (auto& points : result.cell_points) {
    const Eigen::Matrix3Xd all =
        mesh::interpolate<3>(points, {&to_three, &to_three, &to_three});
    Eigen::Matrix3Xd given(3, 20);
    for (int a = 0; a < 20; ++a) {
      given.col(a) = all.col(order[static_cast<std::size_t>(a)]);
    }
    points = given * complete.transpose();
  }
  return result;
}

std::vector<Group> groups_of(const Discretization<3>& discretization,
                             const NodeReduction& reduction) {
  const bool is_tensor = discretization.shape == CellShape::kTensor;
  std::vector<Group> groups;
  for (std::size_t g = 0; g < discretization.groups.size(); ++g) {
    Group group{discretization.groups[g].name, {}, {}};
    for (const int node :
         elasticity::group_nodes(discretization, static_cast<int>(g))) {
      if (reduction.number(node) >= 0) {
        group.nodes.push_back(reduction.number(node));
      }
    }
    for (const auto& [cell, face] : discretization.group_faces[g]) {
      const auto local = static_cast<std::size_t>(face);
      group.faces.push_back({cell, is_tensor ? kHexahedronFace.at(local)
                                             : kTetrahedronFace.at(local)});
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace

Model make_model(const elasticity::ElasticProblem<3>& problem,
                 Hexahedron hexahedron) {
  const bool is_tensor = problem.mesh.shape == CellShape::kTensor;
  const auto discretization = elasticity::discretize<3>(
      is_tensor ? with_serendipity_geometry(problem.mesh) : problem.mesh, 2);
  const NodeReduction reduction(discretization);
  const auto positions = elasticity::node_positions(discretization);

  Model model;
  model.name = problem.name;
  model.element = !is_tensor                           ? "C3D10"
                  : hexahedron == Hexahedron::kReduced ? "C3D20R"
                                                       : "C3D20";
  model.material = problem.material;
  model.nodes.resize(3, reduction.count());
  for (int node = 0; node < discretization.nodes; ++node) {
    const int number = reduction.number(node);
    if (number >= 0) model.nodes.col(number) = positions.col(node);
  }
  for (const auto& cell : discretization.cell_nodes) {
    std::vector<int> element;
    for (const std::size_t i : reduction.functions()) {
      element.push_back(reduction.number(cell[i]));
    }
    model.elements.push_back(std::move(element));
  }
  model.groups = groups_of(discretization, reduction);

  const elasticity::FoundationStiffness<3> beds(
      discretization, problem.foundations, problem.name);
  model.springs = bed_springs(beds, reduction);
  const bool is_free = problem.fixed.empty() && beds.empty();
  const MatrixXd modes = elasticity::rigid_modes<3>(
      positions, positions.rowwise().mean(),
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm());
  MatrixXd loads = elasticity::assemble_loads(
      discretization, problem.history, problem.material.density, problem.name);
  if (is_free) {
    elasticity::balance_loads(discretization, problem.material.density, modes,
                              loads);
  }
  for (const int dof :
       determinate_dofs(discretization, problem, beds, modes, loads)) {
    const int number = reduction.number(dof / 3);
    if (number >= 0) model.supports.push_back({number, dof % 3});
  }
  model.loads = reduction.reduce(loads);
  for (const auto& instant : problem.history.instants) {
    model.labels.push_back(instant.label);
  }
  return model;
}

double strain_energy(const Model& model, int step,
                     const Eigen::Matrix3Xd& displacement) {
  return 0.5 * model.loads.col(step).dot(displacement.reshaped());
}

}  // namespace clevis::calculix
