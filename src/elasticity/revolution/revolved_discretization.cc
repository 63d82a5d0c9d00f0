#include "elasticity/revolution/revolved_discretization.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/fe_space/tabulation.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

AngularGrid::AngularGrid(int highest_order) {
  constexpr double kWaves = 2.0;  // of the highest order in a sector
  // Peaks round the axis are sought at quarters of a sector.
  const int fewest = highest_order == 0 ? 4 : 8;
  // A multiple of four puts planes of nodes at 0, 90, 180 and 270°.
  const int quarter = static_cast<int>(std::ceil(highest_order / kWaves / 4));
  sectors = std::max(fewest, 4 * quarter);
  const Eigen::VectorXd along = mesh::gauss_lobatto(kDegree);
  angles.resize(sectors * kDegree);
  for (int s = 0; s < sectors; ++s) {
    for (int k = 0; k < kDegree; ++k) {
      angles[kDegree * s + k] =
          2.0 * std::numbers::pi * (s + along[k]) / sectors;
    }
  }
}

namespace {

/// Which function of the meridian's basis stands at each lexicographic place.
std::vector<std::size_t> lexicographic(const Discretization<2>& meridian) {
  const auto support =
      displacement_support_points<2>(meridian.shape, meridian.degree);
  const Eigen::VectorXd line = mesh::gauss_lobatto(meridian.degree);
  const auto digit = [&](double x) {
    Index nearest = 0;
    (line.array() - x).abs().minCoeff(&nearest);
    return nearest;
  };
  std::vector<std::size_t> function(static_cast<std::size_t>(support.cols()));
  for (Index i = 0; i < support.cols(); ++i) {
    const Index place =
        digit(support(0, i)) + (meridian.degree + 1) * digit(support(1, i));
    function[static_cast<std::size_t>(place)] = static_cast<std::size_t>(i);
  }
  return function;
}

Eigen::Matrix3Xd turned_points(const Eigen::Matrix2Xd& points,
                               const mesh::Revolution& solid, double start,
                               double span) {
  const Eigen::VectorXd along = mesh::gauss_lobatto(AngularGrid::kDegree);
  Eigen::Matrix3Xd result(3, points.cols() * along.size());
  for (Index k = 0; k < along.size(); ++k) {
    for (Index i = 0; i < points.cols(); ++i) {
      result.col(k * points.cols() + i) =
          solid.at(points.col(i), start + span * along[k]);
    }
  }
  return result;
}

}  // namespace

Discretization<3> revolve(const Discretization<2>& meridian,
                          const mesh::Revolution& solid,
                          const AngularGrid& grid) {
  constexpr int q = AngularGrid::kDegree;
  const auto planes = static_cast<int>(grid.angles.size());
  Discretization<3> result;
  result.shape = meridian.shape;
  result.degree = meridian.degree;
  result.geometry_degree = meridian.geometry_degree;
  result.thickness_degree = q;
  result.geometry_thickness_degree = q;
  result.is_revolved = true;
  result.nodes = planes * meridian.nodes;
  result.groups = meridian.groups;
  result.group_faces.resize(meridian.group_faces.size());
  const auto function = lexicographic(meridian);
  const double span = 2.0 * std::numbers::pi / grid.sectors;
  for (int s = 0; s < grid.sectors; ++s) {
    for (std::size_t c = 0; c < meridian.cell_nodes.size(); ++c) {
      auto& nodes = result.cell_nodes.emplace_back();
      for (int k = 0; k <= q; ++k) {
        const int plane = (q * s + k) % planes;
        for (const std::size_t i : function) {
          nodes.push_back(plane * meridian.nodes + meridian.cell_nodes[c][i]);
        }
      }
      result.cell_points.push_back(
          turned_points(meridian.cell_points[c], solid, s * span, span));
    }
    for (std::size_t g = 0; g < meridian.group_faces.size(); ++g) {
      for (const auto& face : meridian.group_faces[g]) {
        result.group_faces[g].push_back(
            {face.cell + s * meridian.cells(), face.face});
      }
    }
    for (std::size_t v = 0; v < meridian.vertices.size(); ++v) {
      const int node = meridian.vertex_nodes[v];
      result.vertices.push_back(solid.at(meridian.vertices[v], s * span));
      result.vertex_nodes.push_back(node < 0 ? -1
                                             : q * s * meridian.nodes + node);
    }
  }
  return result;
}

MatrixXd sum_harmonics(const std::vector<Harmonic>& harmonics,
                       const std::vector<MatrixXd>& amplitudes,
                       const mesh::Revolution& solid, const AngularGrid& grid) {
  const Index planes = grid.angles.size();
  if (harmonics.empty()) return {};
  const Index nodes = amplitudes.front().rows() / 3;
  const Index columns = amplitudes.front().cols();
  const auto terms = static_cast<Index>(harmonics.size());
  const Eigen::Matrix3d mix = mix_components();
  // (u_x, u_r, u_θ) of every term, then of every plane.
  std::array<MatrixXd, 3> turned;
  for (Index d = 0; d < 3; ++d) {
    MatrixXd terms_of(nodes * columns, terms);
    MatrixXd waves(terms, planes);
    for (Index h = 0; h < terms; ++h) {
      const auto at = static_cast<std::size_t>(h);
      for (Index a = 0; a < planes; ++a) {
        waves(h, a) = wave(harmonics[at], grid.angles[a])[d];
      }
      for (Index k = 0; k < columns; ++k) {
        for (Index i = 0; i < nodes; ++i) {
          terms_of(k * nodes + i, h) =
              mix.row(d).dot(amplitudes[at].col(k).segment<3>(3 * i));
        }
      }
    }
    turned[static_cast<std::size_t>(d)] = product(terms_of, waves);
  }
  MatrixXd result(3 * planes * nodes, columns);
  for (Index a = 0; a < planes; ++a) {
    const double c = std::cos(grid.angles[a]);
    const double s = std::sin(grid.angles[a]);
    for (Index k = 0; k < columns; ++k) {
      for (Index i = 0; i < nodes; ++i) {
        const Index row = k * nodes + i;
        const double radial = turned[1](row, a);
        const double round = turned[2](row, a);
        result.col(k).segment<3>(3 * (a * nodes + i)) =
            solid.axes * Vector3d(turned[0](row, a), c * radial - s * round,
                                  s * radial + c * round);
      }
    }
  }
  return result;
}

}  // namespace clevis::elasticity
