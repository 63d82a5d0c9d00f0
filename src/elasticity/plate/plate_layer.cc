#include "elasticity/plate/plate_layer.h"

#include <cassert>
#include <cmath>

#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using mesh::CellShape;

/// The plane's function and the height of each function of the layer's cell.
struct LayerFunction {
  std::size_t plane{};
  int height{};
};

std::vector<LayerFunction> layer_functions(Degree degree) {
  const auto points =
      displacement_support_points<3>(CellShape::kTensor, degree);
  const auto below =
      displacement_support_points<2>(CellShape::kTensor, degree.plane);
  const Eigen::VectorXd heights = mesh::gauss_lobatto(degree.thickness);
  std::vector<LayerFunction> functions;
  for (Index i = 0; i < points.cols(); ++i) {
    Index plane = 0;
    Index height = 0;
    (below.colwise() - points.col(i).head<2>())
        .colwise()
        .squaredNorm()
        .minCoeff(&plane);
    (heights.array() - points(2, i)).abs().minCoeff(&height);
    functions.push_back(
        {static_cast<std::size_t>(plane), static_cast<int>(height)});
  }
  return functions;
}

Eigen::Matrix3Xd lids(const Eigen::Matrix2Xd& points, double low, double high) {
  Eigen::Matrix3Xd result(3, 2 * points.cols());
  result.topRows<2>() << points, points;
  result.row(2).head(points.cols()).setConstant(low);
  result.row(2).tail(points.cols()).setConstant(high);
  return result;
}

}  // namespace

Discretization<3> layer_over(const Discretization<2>& plane,
                             int thickness_degree) {
  assert(plane.shape == CellShape::kTensor);
  Discretization<3> layer;
  layer.shape = plane.shape;
  layer.is_layer = true;
  layer.degree = plane.degree;
  layer.geometry_degree = plane.geometry_degree;
  layer.thickness_degree = thickness_degree;
  layer.geometry_thickness_degree = 1;
  const int heights = thickness_degree + 1;
  layer.nodes = plane.nodes * heights;
  const double low = plane.mid_plane_z - 0.5 * plane.thickness;
  const double high = plane.mid_plane_z + 0.5 * plane.thickness;
  const auto functions = layer_functions(layer.displacement_degree());
  for (std::size_t c = 0; c < plane.cell_nodes.size(); ++c) {
    auto& nodes = layer.cell_nodes.emplace_back();
    for (const auto& [function, height] : functions) {
      nodes.push_back(plane.cell_nodes[c][function] * heights + height);
    }
    layer.cell_points.push_back(lids(plane.cell_points[c], low, high));
  }
  layer.group_faces = plane.group_faces;  // the same numbers, d = 0 and 1
  layer.groups = plane.groups;
  for (const bool top : {false, true}) {
    for (std::size_t v = 0; v < plane.vertices.size(); ++v) {
      const int node = plane.vertex_nodes[v];
      layer.vertex_nodes.push_back(
          node < 0 ? -1 : node * heights + (top ? thickness_degree : 0));
      layer.vertices.emplace_back(plane.vertices[v].x(), plane.vertices[v].y(),
                                  top ? high : low);
    }
  }
  return layer;
}

ThicknessReduction::ThicknessReduction(Parity parity, int terms)
    : parity_(parity), terms_(terms) {
  const int degree = 2 * terms - 1;
  const MatrixXd table =
      legendre_table(degree, mesh::gauss_lobatto(degree)).transpose();
  in_plane_.resize(degree + 1, terms);
  transverse_.resize(degree + 1, terms);
  for (int a = 0; a < terms; ++a) {
    in_plane_.col(a) = table.col(in_plane_order(parity, a));
    transverse_.col(a) = table.col(transverse_order(parity, a));
  }
}

namespace {

/// to[i] = Σ_k weight(i, k) from[k stride], as plain loops: the blocks are too
/// small for a library.
void apply(const MatrixXd& weight, const double* from, Index from_stride,
           double* to, Index to_stride) {
  for (Index i = 0; i < weight.rows(); ++i) {
    double sum = 0.0;
    for (Index k = 0; k < weight.cols(); ++k) {
      sum += weight(i, k) * from[k * from_stride];
    }
    to[i * to_stride] = sum;
  }
}

}  // namespace

MatrixXd ThicknessReduction::expand(const MatrixXd& terms) const {
  const Index heights = in_plane_.rows();
  const Index n = terms_;
  const Index nodes = terms.rows() / (3 * n);
  MatrixXd nodal(3 * heights * nodes, terms.cols());
  for (Index column = 0; column < terms.cols(); ++column) {
    for (Index i = 0; i < nodes; ++i) {
      for (Index c = 0; c < 3; ++c) {
        apply(c < 2 ? in_plane_ : transverse_,
              &terms(3 * n * i + n * c, column), 1,
              &nodal(3 * heights * i + c, column), 3);
      }
    }
  }
  return nodal;
}

MatrixXd ThicknessReduction::reduce(const MatrixXd& nodal) const {
  const Index heights = in_plane_.rows();
  const Index n = terms_;
  const Index nodes = nodal.rows() / (3 * heights);
  const MatrixXd in_plane = in_plane_.transpose();
  const MatrixXd transverse = transverse_.transpose();
  MatrixXd terms(3 * n * nodes, nodal.cols());
  for (Index column = 0; column < nodal.cols(); ++column) {
    for (Index i = 0; i < nodes; ++i) {
      for (Index c = 0; c < 3; ++c) {
        apply(c < 2 ? in_plane : transverse,
              &nodal(3 * heights * i + c, column), 3,
              &terms(3 * n * i + n * c, column), 1);
      }
    }
  }
  return terms;
}

MatrixXd ThicknessReduction::rigid_modes(const Eigen::Matrix2Xd& positions,
                                         double thickness) const {
  const Index n = terms_;
  const Index nodes = positions.cols();
  const double half = 0.5 * thickness;  // z is half of it times P_1
  MatrixXd modes = MatrixXd::Zero(3 * n * nodes, 3);
  for (Index i = 0; i < nodes; ++i) {
    const auto first_of = [&](Index component, Index mode) -> double& {
      return modes(3 * n * i + n * component, mode);
    };
    const double x = positions(0, i), y = positions(1, i);
    if (parity_ == Parity::kStretching) {
      first_of(0, 0) = first_of(1, 1) = 1.0;
      first_of(0, 2) = -y;
      first_of(1, 2) = x;
    } else {
      first_of(2, 0) = 1.0;
      first_of(1, 1) = -half;
      first_of(2, 1) = y;
      first_of(0, 2) = half;
      first_of(2, 2) = -x;
    }
  }
  return modes;
}

}  // namespace clevis::elasticity
