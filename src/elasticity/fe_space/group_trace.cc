#include "elasticity/fe_space/group_trace.h"

#include <algorithm>
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

/// Fills geometry, functions and values of a table that has its rule.
template <int dim>
void tabulate(const Discretization<dim>& discretization,
              FaceTable<dim>& table) {
  table.geometry = CellInterpolation<dim>(
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
}

}  // namespace

template <int dim>
const FaceTable<dim>& whole_face_table(
    const Discretization<dim>& discretization, int face,
    FaceTables<dim>& tables) {
  if (const auto found = tables.find(face); found != tables.end()) {
    return found->second;
  }
  // More points than the degree needs, for the kinks of a bearing pressure:
  // round the bore, and through a plate where its pin tilts. The rest of their
  // error is taken out by the discrete balance.
  const int p = discretization.degree;
  const int q = discretization.thickness_degree;
  const bool plate = dim == 2 || discretization.is_layer;
  const Degree points = {p + (plate ? 28 : 4), q + (plate ? 10 : 4)};
  FaceTable<dim>& table = tables[face];
  table.rule = face_gauss<dim>(discretization.shape, face, points);
  tabulate(discretization, table);
  return table;
}

template <int dim>
WeightedSurface weighted_surface(const Discretization<dim>& discretization,
                                 int cell, const FaceTable<dim>& table) {
  const auto at = cell_geometry<dim>(
      discretization.cell_points[static_cast<std::size_t>(cell)],
      table.geometry);
  const Index n = at.points.cols();
  WeightedSurface surface{Eigen::Matrix3Xd(3, n), Eigen::Matrix3Xd(3, n)};
  for (Index q = 0; q < n; ++q) {
    const Eigen::Matrix<double, dim, 1> area =
        discretization.thickness * table.rule.weights[q] * at.determinant[q] *
        at.inverse_jacobian[static_cast<std::size_t>(q)].transpose() *
        table.rule.outward;
    surface.points.col(q) =
        in_space<dim>(at.points.col(q), discretization.mid_plane_z);
    surface.areas.col(q) = in_space<dim>(area, 0.0);
  }
  return surface;
}

template <int dim>
void TraceBuilder<dim>::add(int cell, const std::vector<std::size_t>& functions,
                            const MatrixXd& values,
                            const WeightedSurface& surface) {
  for (Index q = 0; q < surface.points.cols(); ++q) {
    points_.emplace_back(surface.points.col(q));
    areas_.emplace_back(surface.areas.col(q));
  }
  GroupTrace::Face entry{{}, &values};
  const auto& nodes =
      discretization_.cell_nodes[static_cast<std::size_t>(cell)];
  for (const std::size_t i : functions) entry.nodes.push_back(nodes[i]);
  faces_.push_back(std::move(entry));
}

template <int dim>
GroupTrace TraceBuilder<dim>::finish() {
  GroupTrace trace;
  trace.faces = std::move(faces_);
  const auto n = static_cast<Index>(points_.size());
  trace.quadrature.points.resize(3, n);
  trace.quadrature.weights.resize(n);
  trace.outward.resize(3, n);
  for (Index q = 0; q < n; ++q) {
    const auto k = static_cast<std::size_t>(q);
    trace.quadrature.points.col(q) = points_[k];
    trace.quadrature.weights[q] = areas_[k].norm();
    trace.outward.col(q) = areas_[k].normalized();
  }
  return trace;
}

template <int dim>
GroupTrace group_trace(const Discretization<dim>& discretization, int group,
                       FaceTables<dim>& tables) {
  TraceBuilder<dim> builder(discretization);
  for (const GroupFace& face :
       discretization.group_faces[static_cast<std::size_t>(group)]) {
    const auto& table = whole_face_table(discretization, face.face, tables);
    builder.add(face.cell, table.functions, table.values,
                weighted_surface(discretization, face.cell, table));
  }
  return builder.finish();
}

template <int dim>
bool has_faces(const Discretization<dim>& discretization,
               const std::string& group) {
  const auto found = std::ranges::find(discretization.groups, group,
                                       &mesh::SurfaceGroup::name);
  return found != discretization.groups.end() &&
         !discretization
              .group_faces[static_cast<std::size_t>(
                  found - discretization.groups.begin())]
              .empty();
}

#define CLEVIS_INSTANTIATE(dim)                                               \
  template WeightedSurface weighted_surface<dim>(const Discretization<dim>&,  \
                                                 int, const FaceTable<dim>&); \
  template const FaceTable<dim>& whole_face_table<dim>(                       \
      const Discretization<dim>&, int, FaceTables<dim>&);                     \
  template class TraceBuilder<dim>;                                           \
  template GroupTrace group_trace<dim>(const Discretization<dim>&, int,       \
                                       FaceTables<dim>&);                     \
  template bool has_faces<dim>(const Discretization<dim>&, const std::string&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
