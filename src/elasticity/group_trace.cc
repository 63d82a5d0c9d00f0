#include "elasticity/group_trace.h"

#include <utility>

#include <Eigen/LU>

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

template <int dim>
Vector3d in_space(const Eigen::Matrix<double, dim, 1>& x, double z) {
  if constexpr (dim == 2) {
    return {x[0], x[1], z};
  } else {
    return x;
  }
}

template <int dim>
FaceTable<dim> face_table(const Discretization<dim>& discretization, int face) {
  // More points than the degree needs, for the kink of a bearing pressure;
  // the rest of its error is taken out by the discrete balance.
  const int p = discretization.degree;
  const int q = discretization.thickness_degree;
  const bool plate = dim == 2 || discretization.is_layer;
  const Degree points = {p + (plate ? 28 : 4), q + (plate ? 2 : 4)};
  FaceTable<dim> table;
  table.rule = face_gauss<dim>(discretization.shape, face, points);
  table.geometry = tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), table.rule.points);
  const MatrixXd values =
      tabulate_displacement<dim>(discretization.shape,
                                 discretization.displacement_degree(),
                                 table.rule.points)
          .values;
  for (Index i = 0; i < values.cols(); ++i) {
    if (values.col(i).cwiseAbs().maxCoeff() < 1e-10) continue;
    table.functions.push_back(static_cast<std::size_t>(i));
  }
  table.values.resize(values.rows(),
                      static_cast<Index>(table.functions.size()));
  for (std::size_t k = 0; k < table.functions.size(); ++k) {
    table.values.col(static_cast<Index>(k)) =
        values.col(static_cast<Index>(table.functions[k]));
  }
  return table;
}

}  // namespace

template <int dim>
GroupTrace group_trace(const Discretization<dim>& discretization, int group,
                       FaceTables<dim>& tables) {
  GroupTrace trace;
  std::vector<Vector3d> points;
  std::vector<Vector3d> normals;
  std::vector<double> weights;
  for (const auto& [cell, face] :
       discretization.group_faces[static_cast<std::size_t>(group)]) {
    if (!tables.contains(face)) {
      tables.emplace(face, face_table(discretization, face));
    }
    const FaceTable<dim>& table = tables.at(face);
    const auto c = static_cast<std::size_t>(cell);
    const auto at =
        cell_geometry<dim>(discretization.cell_points[c], table.geometry);
    for (Index q = 0; q < at.points.cols(); ++q) {
      const Eigen::Matrix<double, dim, 1> area =
          at.determinant[q] *
          at.inverse_jacobian[static_cast<std::size_t>(q)].transpose() *
          table.rule.outward;
      points.push_back(
          in_space<dim>(at.points.col(q), discretization.mid_plane_z));
      normals.push_back(in_space<dim>(area.normalized(), 0.0));
      weights.push_back(table.rule.weights[q] * area.norm() *
                        discretization.thickness);
    }
    GroupTrace::Face entry{{}, &table.values};
    for (const std::size_t i : table.functions) {
      entry.nodes.push_back(discretization.cell_nodes[c][i]);
    }
    trace.faces.push_back(std::move(entry));
  }
  const auto n = static_cast<Index>(points.size());
  trace.quadrature.points.resize(3, n);
  trace.quadrature.weights.resize(n);
  trace.outward.resize(3, n);
  for (Index q = 0; q < n; ++q) {
    const auto k = static_cast<std::size_t>(q);
    trace.quadrature.points.col(q) = points[k];
    trace.quadrature.weights[q] = weights[k];
    trace.outward.col(q) = normals[k];
  }
  return trace;
}

template GroupTrace group_trace<2>(const Discretization<2>&, int,
                                   FaceTables<2>&);
template GroupTrace group_trace<3>(const Discretization<3>&, int,
                                   FaceTables<3>&);

}  // namespace clevis::elasticity
