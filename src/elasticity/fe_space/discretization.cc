#include "elasticity/fe_space/discretization.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "base/messages/errors.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/fe_space/simplex_numbering.h"
#include "elasticity/fe_space/tensor_numbering.h"
#include "mesh/cells/cell_orientation.h"

namespace clevis::elasticity {
namespace {

using mesh::CellShape;
using mesh::PartMesh;

/// How a cell that was turned lies in the mesh's: its direction d is the mesh's
/// direction axis[d], reversed if flip[d].
template <int dim>
struct Orientation {
  std::array<int, dim> axis{};
  std::array<bool, dim> flip{};
};

template <int dim>
Orientation<dim> orientation(const std::vector<unsigned>& mesh_vertices,
                             const std::vector<unsigned>& vertices) {
  const auto corner = [&](unsigned vertex) {
    return static_cast<unsigned>(std::ranges::find(mesh_vertices, vertex) -
                                 mesh_vertices.begin());
  };
  Orientation<dim> result;
  const unsigned origin = corner(vertices[0]);
  for (unsigned d = 0; d < dim; ++d) {
    const unsigned changed = origin ^ corner(vertices[1U << d]);
    int axis = 0;
    while ((changed >> axis) != 1U) ++axis;
    result.axis[d] = axis;
    result.flip[d] = ((origin >> axis) & 1U) != 0;
  }
  return result;
}

template <int dim>
Eigen::Matrix<double, dim, Eigen::Dynamic> permute_points(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& points, int degree,
    const Orientation<dim>& to_mesh) {
  Eigen::Matrix<double, dim, Eigen::Dynamic> result(dim, points.cols());
  const int n = degree + 1;
  for (int index = 0; index < points.cols(); ++index) {
    int rest = index;
    int source = 0;
    for (unsigned d = 0; d < dim; ++d) {
      int position = rest % n;
      rest /= n;
      if (to_mesh.flip[d]) position = degree - position;
      int stride = 1;
      for (int k = 0; k < to_mesh.axis[d]; ++k) stride *= n;
      source += position * stride;
    }
    result.col(index) = points.col(source);
  }
  return result;
}

template <int dim>
int permute_face(int mesh_face, const Orientation<dim>& to_mesh) {
  for (unsigned d = 0; d < dim; ++d) {
    if (to_mesh.axis[d] != mesh_face / 2) continue;
    const int side = (mesh_face % 2) ^ static_cast<int>(to_mesh.flip[d]);
    return 2 * static_cast<int>(d) + side;
  }
  return -1;
}

/// Numbers the nodes and turns the cells.
template <int dim>
void add_tensor_cells(const PartMesh<dim>& mesh,
                      const Eigen::MatrixXd& to_degree,
                      Discretization<dim>& result) {
  auto cells = mesh.cells;
  mesh::orient_cells<dim>(cells);
  TensorNumbering numbering =
      number_tensor_cells<dim>(cells, mesh.vertices.size(), result.degree);
  result.nodes = numbering.nodes;
  result.cell_nodes = std::move(numbering.cell_nodes);
  result.vertex_nodes = std::move(numbering.vertex_nodes);
  std::vector<Orientation<dim>> orientations;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    orientations.push_back(orientation<dim>(mesh.cells[c], cells[c]));
    result.cell_points.emplace_back(
        permute_points<dim>(mesh.cell_points[c], mesh.degree, orientations[c]) *
        to_degree);
  }
  for (const auto& face : mesh.boundary) {
    if (face.group < 0) continue;
    const auto cell = static_cast<std::size_t>(face.cell);
    result.group_faces[static_cast<std::size_t>(face.group)].push_back(
        {face.cell, permute_face<dim>(face.face, orientations[cell])});
  }
}

template <int dim>
void add_simplices(const PartMesh<dim>& mesh, const Eigen::MatrixXd& to_degree,
                   Discretization<dim>& result) {
  SimplexNumbering numbering = number_simplices<dim>(mesh, result.degree);
  result.nodes = numbering.nodes;
  result.cell_nodes = std::move(numbering.cell_nodes);
  result.vertex_nodes = std::move(numbering.vertex_nodes);
  for (const auto& points : mesh.cell_points) {
    result.cell_points.emplace_back(points * to_degree);
  }
  for (const auto& face : mesh.boundary) {
    if (face.group < 0) continue;
    result.group_faces[static_cast<std::size_t>(face.group)].push_back(
        {face.cell, face.face});
  }
}

}  // namespace

template <int dim>
Discretization<dim> discretize(const PartMesh<dim>& mesh, int degree) {
  Discretization<dim> result;
  result.shape = mesh.shape;
  result.degree = degree;
  result.geometry_degree = std::min(mesh.degree, degree);
  result.thickness_degree = degree;
  result.geometry_thickness_degree = result.geometry_degree;
  result.vertices = mesh.vertices;
  result.groups = mesh.groups;
  result.group_faces.resize(mesh.groups.size());
  if (dim == 2) {
    result.thickness = mesh.thickness;
    result.mid_plane_z = mesh.mid_plane_z;
  }
  const Eigen::MatrixXd to_degree =
      tabulate_geometry<dim>(
          mesh.shape, mesh.degree,
          geometry_support_points<dim>(mesh.shape, result.geometry_degree))
          .values.transpose();
  if (mesh.shape == CellShape::kTensor) {
    add_tensor_cells<dim>(mesh, to_degree, result);
  } else {
    add_simplices<dim>(mesh, to_degree, result);
  }
  return result;
}

template <int dim>
std::vector<int> group_nodes(const Discretization<dim>& discretization,
                             int group) {
  // A basis function lives on a face exactly if it does not vanish at the
  // face's own quadrature points.
  std::vector<int> nodes;
  std::array<std::vector<int>, 2 * dim> on_face;
  for (const auto& [cell, face] :
       discretization.group_faces[static_cast<std::size_t>(group)]) {
    auto& functions = on_face[static_cast<std::size_t>(face)];
    if (functions.empty()) {
      const auto rule = face_gauss<dim>(discretization.shape, face, 4);
      const auto table = tabulate_displacement<dim>(
          discretization.shape, discretization.displacement_degree(),
          rule.points);
      for (int i = 0; i < table.values.cols(); ++i) {
        if (table.values.col(i).cwiseAbs().maxCoeff() > 1e-10) {
          functions.push_back(i);
        }
      }
    }
    const auto& ids = discretization.cell_nodes[static_cast<std::size_t>(cell)];
    for (int i : functions) nodes.push_back(ids[static_cast<std::size_t>(i)]);
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

template <int dim>
CellGeometry<dim> cell_geometry(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& cell_points,
    const CellInterpolation<dim>& geometry) {
  const Eigen::Index n = geometry.points();
  CellGeometry<dim> result;
  const Eigen::MatrixXd nodes = cell_points.transpose();
  result.points = geometry.values(nodes).transpose();
  result.inverse_jacobian.resize(static_cast<std::size_t>(n));
  result.determinant.resize(n);
  const Eigen::MatrixXd tangents = geometry.gradients(nodes);
  for (Eigen::Index q = 0; q < n; ++q) {
    Eigen::Matrix<double, dim, dim> jacobian;
    for (Eigen::Index d = 0; d < dim; ++d) {
      jacobian.col(d) = tangents.row(d * n + q);
    }
    result.determinant[q] = jacobian.determinant();
    result.inverse_jacobian[static_cast<std::size_t>(q)] = jacobian.inverse();
  }
  return result;
}

namespace {

/// ∂ξ_k/∂x_d at the points: points × k [1/m].
template <int dim>
Eigen::Array<double, Eigen::Dynamic, dim> rates_of_reference(
    const CellGeometry<dim>& geometry, Eigen::Index d) {
  const auto n = static_cast<Eigen::Index>(geometry.inverse_jacobian.size());
  Eigen::Array<double, Eigen::Dynamic, dim> rates(n, dim);
  for (Eigen::Index q = 0; q < n; ++q) {
    rates.row(q) = geometry.inverse_jacobian[static_cast<std::size_t>(q)]
                       .col(d)
                       .transpose()
                       .array();
  }
  return rates;
}

}  // namespace

template <int dim>
Eigen::MatrixXd physical_slopes(const CellGeometry<dim>& geometry,
                                const Eigen::MatrixXd& reference) {
  const auto n = static_cast<Eigen::Index>(geometry.inverse_jacobian.size());
  Eigen::MatrixXd slopes(dim * n, reference.cols());
  // ∂u/∂x_d = Σ_k ∂u/∂ξ_k ∂ξ_k/∂x_d
  for (int d = 0; d < dim; ++d) {
    const auto factor = rates_of_reference<dim>(geometry, d);
    for (Eigen::Index column = 0; column < reference.cols(); ++column) {
      auto slope = slopes.col(column).segment(d * n, n).array();
      slope = factor.col(0) * reference.col(column).head(n).array();
      for (int k = 1; k < dim; ++k) {
        slope +=
            factor.col(k) * reference.col(column).segment(k * n, n).array();
      }
    }
  }
  return slopes;
}

template <int dim>
std::vector<Eigen::MatrixXd> physical_gradients(
    const CellGeometry<dim>& geometry, const Tabulation& displacement) {
  const auto n = displacement.values.rows();
  const auto functions = displacement.values.cols();
  std::vector<Eigen::MatrixXd> result(dim, Eigen::MatrixXd(n, functions));
  // ∂N/∂x_d = Σ_k ∂N/∂ξ_k ∂ξ_k/∂x_d
  for (std::size_t d = 0; d < dim; ++d) {
    const auto factor =
        rates_of_reference<dim>(geometry, static_cast<Eigen::Index>(d));
    const auto term = [&](std::size_t k, Eigen::Index i) {
      return factor.col(static_cast<Eigen::Index>(k)) *
             displacement.gradients[k].col(i).array();
    };
    for (Eigen::Index i = 0; i < functions; ++i) {
      auto column = result[d].col(i).array();
      if constexpr (dim == 2) {
        column = term(0, i) + term(1, i);
      } else {
        column = term(0, i) + term(1, i) + term(2, i);
      }
    }
  }
  return result;
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template Discretization<dim> discretize<dim>(const PartMesh<dim>&, int);     \
  template std::vector<int> group_nodes<dim>(const Discretization<dim>&, int); \
  template CellGeometry<dim> cell_geometry<dim>(                               \
      const Eigen::Matrix<double, dim, Eigen::Dynamic>&,                       \
      const CellInterpolation<dim>&);                                          \
  template Eigen::MatrixXd physical_slopes<dim>(const CellGeometry<dim>&,      \
                                                const Eigen::MatrixXd&);       \
  template std::vector<Eigen::MatrixXd> physical_gradients<dim>(               \
      const CellGeometry<dim>&, const Tabulation&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
