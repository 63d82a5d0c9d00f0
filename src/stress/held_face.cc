#include "stress/held_face.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "elasticity/dense_product.h"
#include "elasticity/group_trace.h"
#include "elasticity/stiffness.h"
#include "elasticity/supports.h"
#include "stress/cell_field.h"
#include "stress/plane_section.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// ∫ σ ∇N dV of cells.
template <int dim>
class NodalForces {
 public:
  NodalForces(const elasticity::Discretization<dim>& discretization,
              const part::Material& material)
      : discretization_(discretization),
        rule_(elasticity::stiffness_quadrature<dim>(discretization)),
        field_(discretization, material, rule_.points),
        geometry_(elasticity::tabulate_geometry<dim>(
            discretization.shape, discretization.mapping_degree(),
            rule_.points)),
        displacement_(elasticity::tabulate_displacement<dim>(
            discretization.shape, discretization.displacement_degree(),
            rule_.points)) {}

  /// Per component the cell's nodes, below each other, × columns [N].
  MatrixXd of(std::size_t cell, const MatrixXd& columns) const {
    static constexpr int kStress[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    const auto at = elasticity::cell_geometry<dim>(
        discretization_.cell_points[cell], geometry_);
    const auto gradients =
        elasticity::physical_gradients<dim>(at, displacement_);
    const Eigen::VectorXd weights =
        discretization_.thickness * at.determinant.cwiseProduct(rule_.weights);
    const MatrixXd stress = field_.stress(cell, columns);
    const Index n = weights.size(), nodes = gradients[0].cols();
    MatrixXd forces = MatrixXd::Zero(dim * nodes, columns.cols());
    for (int a = 0; a < dim; ++a) {
      for (int b = 0; b < dim; ++b) {
        const int k = dim == 2 ? (a == b ? a : 2) : kStress[a][b];
        forces.middleRows(a * nodes, nodes) += elasticity::transposed_product(
            gradients[static_cast<std::size_t>(b)],
            weights.asDiagonal() * stress.middleRows(k * n, n));
      }
    }
    return forces;
  }

 private:
  const elasticity::Discretization<dim>& discretization_;
  elasticity::Quadrature<dim> rule_;
  CellField<dim> field_;
  elasticity::Tabulation geometry_, displacement_;
};

struct Resultants {
  Matrix3Xd force, moment;  ///< about a point, 3 × columns
};

/// Reactions of the group's held components per basis column.
template <int dim>
Resultants reactions(const elasticity::DisplacementBasis<dim>& basis,
                     const part::Material& material, int group,
                     const std::array<bool, 3>& held, const Vector3d& about) {
  const auto& discretization = basis.discretization;
  const auto positions = elasticity::node_positions(discretization);
  const auto nodes = elasticity::group_nodes<dim>(discretization, group);
  const NodalForces<dim> forces_of(discretization, material);
  Resultants sum{Matrix3Xd::Zero(3, basis.columns.cols()),
                 Matrix3Xd::Zero(3, basis.columns.cols())};
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const auto& ids = discretization.cell_nodes[c];
    const auto is_held = [&](int node) {
      return std::ranges::binary_search(nodes, node);
    };
    if (std::ranges::none_of(ids, is_held)) continue;
    const MatrixXd forces = forces_of.of(c, basis.columns);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!is_held(ids[i])) continue;
      Matrix3Xd at_node = Matrix3Xd::Zero(3, basis.columns.cols());
      for (int a = 0; a < dim; ++a) {
        if (!held[static_cast<std::size_t>(a)]) continue;
        at_node.row(a) = forces.row(a * static_cast<Index>(ids.size()) +
                                    static_cast<Index>(i));
      }
      Vector3d arm = Vector3d::Zero();
      arm.head<dim>() = positions.col(ids[i]) - about.head<dim>();
      sum.force += at_node;
      sum.moment += at_node.colwise().cross(-arm);
    }
  }
  return sum;
}

}  // namespace

template <int dim>
std::vector<HeldFace> held_faces(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material,
    const std::map<std::string, std::array<bool, 3>>& fixed) {
  const auto& discretization = basis.discretization;
  const auto positions = elasticity::node_positions(discretization);
  std::vector<HeldFace> faces;
  for (int g = 0; g < static_cast<int>(discretization.groups.size()); ++g) {
    const auto& name = discretization.groups[static_cast<std::size_t>(g)].name;
    const auto held = fixed.find(name);
    if (held == fixed.end()) continue;
    elasticity::FaceTables<dim> tables;
    const auto section =
        plane_section(elasticity::group_trace(discretization, g, tables));
    if (!section) continue;
    const auto nodes = elasticity::group_nodes<dim>(discretization, g);
    Matrix3Xd at = Matrix3Xd::Constant(3, static_cast<Index>(nodes.size()),
                                       discretization.mid_plane_z);
    at.topRows<dim>() = positions(Eigen::all, nodes);
    const Resultants unit =
        reactions<dim>(basis, material, g, held->second, section->centroid);
    HeldFace face{name,
                  unit.force * basis.coefficients,
                  unit.moment * basis.coefficients,
                  {}};
    face.nominal = nominal_stress(*section, face.force, face.moment, at);
    faces.push_back(std::move(face));
  }
  return faces;
}

template std::vector<HeldFace> held_faces<2>(
    const elasticity::DisplacementBasis<2>&, const part::Material&,
    const std::map<std::string, std::array<bool, 3>>&);
template std::vector<HeldFace> held_faces<3>(
    const elasticity::DisplacementBasis<3>&, const part::Material&,
    const std::map<std::string, std::array<bool, 3>>&);

}  // namespace clevis::stress
