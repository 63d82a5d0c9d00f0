#include "elasticity/tabulation.h"

#include <cassert>
#include <memory>

#include <Eigen/Geometry>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

namespace clevis::elasticity {
namespace {

using mesh::CellShape;

template <int dim>
dealii::Point<dim> to_point(const Eigen::Matrix<double, dim, 1>& x) {
  dealii::Point<dim> point;
  for (int d = 0; d < dim; ++d) point[static_cast<unsigned>(d)] = x[d];
  return point;
}

template <int dim>
Tabulation tabulate(const dealii::FiniteElement<dim>& fe,
                    const ReferencePoints<dim>& points,
                    const std::vector<unsigned>& order) {
  const auto n_points = points.cols();
  const auto n_functions = static_cast<Eigen::Index>(fe.n_dofs_per_cell());
  Tabulation table;
  table.values.resize(n_points, n_functions);
  table.gradients.assign(dim, Eigen::MatrixXd(n_points, n_functions));
  for (Eigen::Index q = 0; q < n_points; ++q) {
    const auto point = to_point<dim>(points.col(q));
    for (Eigen::Index i = 0; i < n_functions; ++i) {
      const unsigned function = order[static_cast<std::size_t>(i)];
      table.values(q, i) = fe.shape_value(function, point);
      const auto gradient = fe.shape_grad(function, point);
      for (unsigned d = 0; d < dim; ++d) table.gradients[d](q, i) = gradient[d];
    }
  }
  return table;
}

std::vector<unsigned> identity(unsigned n) {
  std::vector<unsigned> order(n);
  for (unsigned i = 0; i < n; ++i) order[i] = i;
  return order;
}

}  // namespace

template <int dim>
Tabulation tabulate_displacement(CellShape shape, int degree,
                                 const ReferencePoints<dim>& points) {
  const auto p = static_cast<unsigned>(degree);
  if (shape == CellShape::kTensor) {
    const dealii::FE_Q<dim> fe(p);
    return tabulate<dim>(fe, points, identity(fe.n_dofs_per_cell()));
  }
  const dealii::FE_SimplexP<dim> fe(p);
  return tabulate<dim>(fe, points, identity(fe.n_dofs_per_cell()));
}

template <int dim>
Tabulation tabulate_geometry(CellShape shape, int degree,
                             const ReferencePoints<dim>& points) {
  if (shape == CellShape::kTensor) {
    const dealii::FE_Q<dim> fe(static_cast<unsigned>(degree));
    return tabulate<dim>(fe, points, fe.get_poly_space_numbering_inverse());
  }
  assert(degree == 1 && "simplices carry their vertices only");
  const dealii::FE_SimplexP<dim> fe(1);
  return tabulate<dim>(fe, points, identity(fe.n_dofs_per_cell()));
}

template <int dim>
ReferencePoints<dim> displacement_support_points(CellShape shape, int degree) {
  const auto p = static_cast<unsigned>(degree);
  const auto points =
      shape == CellShape::kTensor
          ? dealii::FE_Q<dim>(p).get_unit_support_points()
          : dealii::FE_SimplexP<dim>(p).get_unit_support_points();
  ReferencePoints<dim> result(dim, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (unsigned d = 0; d < dim; ++d) {
      result(d, static_cast<Eigen::Index>(i)) = points[i][d];
    }
  }
  return result;
}

template <int dim>
ReferencePoints<dim> geometry_support_points(CellShape shape, int degree) {
  const auto points = displacement_support_points<dim>(shape, degree);
  if (shape == CellShape::kSimplex) return points;
  const auto order = dealii::FE_Q<dim>(static_cast<unsigned>(degree))
                         .get_poly_space_numbering_inverse();
  ReferencePoints<dim> result(dim, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    result.col(i) = points.col(order[static_cast<std::size_t>(i)]);
  }
  return result;
}

template <int dim>
Quadrature<dim> gauss(CellShape shape, int n) {
  std::unique_ptr<dealii::Quadrature<dim>> rule;
  if (shape == CellShape::kTensor) {
    rule = std::make_unique<dealii::QGauss<dim>>(static_cast<unsigned>(n));
  } else {
    rule =
        std::make_unique<dealii::QGaussSimplex<dim>>(static_cast<unsigned>(n));
  }
  const auto size = static_cast<Eigen::Index>(rule->size());
  Quadrature<dim> result{ReferencePoints<dim>(dim, size),
                         Eigen::VectorXd(size)};
  for (Eigen::Index q = 0; q < size; ++q) {
    const auto index = static_cast<unsigned>(q);
    for (unsigned d = 0; d < dim; ++d) {
      result.points(d, q) = rule->point(index)[d];
    }
    result.weights[q] = rule->weight(index);
  }
  return result;
}

template <int dim>
FaceQuadrature<dim> face_gauss(CellShape shape, int face, int n) {
  const Quadrature<dim - 1> rule = gauss<dim - 1>(shape, n);
  const auto size = rule.points.cols();
  FaceQuadrature<dim> result;
  result.points.resize(dim, size);
  result.weights = rule.weights;
  result.outward.setZero();
  if (shape == CellShape::kTensor) {
    const int fixed = face / 2;
    const double side = face % 2;
    result.outward[fixed] = 2.0 * side - 1.0;
    for (Eigen::Index q = 0; q < size; ++q) {
      for (int d = 0, from = 0; d < dim; ++d) {
        result.points(d, q) = d == fixed ? side : rule.points(from++, q);
      }
    }
    return result;
  }
  // Corners of the face, deal.II's numbering; the outward normal carries the
  // ratio of the face's area to that of the reference face.
  static constexpr int kTriangle[3][2] = {{0, 1}, {1, 2}, {2, 0}};
  static constexpr int kTetrahedron[4][3] = {
      {0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}};
  Eigen::Matrix<double, dim, dim + 1> corners;
  corners.setZero();
  corners.template rightCols<dim>().setIdentity();
  Eigen::Matrix<double, dim, dim> at;
  for (int k = 0; k < dim; ++k) {
    int corner = 0;
    if constexpr (dim == 2) corner = kTriangle[face][k];
    if constexpr (dim == 3) corner = kTetrahedron[face][k];
    at.col(k) = corners.col(corner);
  }
  result.points = at.col(0).replicate(1, size);
  for (int k = 1; k < dim; ++k) {
    result.points += (at.col(k) - at.col(0)) * rule.points.row(k - 1);
  }
  if constexpr (dim == 2) {
    const Eigen::Vector2d along = at.col(1) - at.col(0);
    result.outward = Eigen::Vector2d(along[1], -along[0]);
  } else {
    const Eigen::Vector3d first = at.col(1) - at.col(0);
    const Eigen::Vector3d second = at.col(2) - at.col(0);
    result.outward = first.cross(second);
  }
  const Eigen::Matrix<double, dim, 1> centre =
      Eigen::Matrix<double, dim, 1>::Constant(1.0 / (dim + 1));
  if (result.outward.dot(at.col(0) - centre) < 0.0) result.outward *= -1.0;
  return result;
}

template <int dim>
ReferencePoints<dim> lattice(CellShape shape, int subdivisions) {
  std::vector<Eigen::Matrix<double, dim, 1>> points;
  const int n = subdivisions;
  const int layers = dim == 3 ? n : 0;
  for (int k = 0; k <= layers; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        if (shape == CellShape::kSimplex && i + j + k > n) continue;
        Eigen::Matrix<double, dim, 1> x;
        x[0] = static_cast<double>(i) / n;
        x[1] = static_cast<double>(j) / n;
        if constexpr (dim == 3) x[2] = static_cast<double>(k) / n;
        points.push_back(x);
      }
    }
  }
  ReferencePoints<dim> result(dim, static_cast<Eigen::Index>(points.size()));
  for (std::size_t q = 0; q < points.size(); ++q) {
    result.col(static_cast<Eigen::Index>(q)) = points[q];
  }
  return result;
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template Tabulation tabulate_displacement<dim>(CellShape, int,               \
                                                 const ReferencePoints<dim>&); \
  template Tabulation tabulate_geometry<dim>(CellShape, int,                   \
                                             const ReferencePoints<dim>&);     \
  template ReferencePoints<dim> displacement_support_points<dim>(CellShape,    \
                                                                 int);         \
  template ReferencePoints<dim> geometry_support_points<dim>(CellShape, int);  \
  template Quadrature<dim> gauss<dim>(CellShape, int);                         \
  template FaceQuadrature<dim> face_gauss<dim>(CellShape, int, int);           \
  template ReferencePoints<dim> lattice<dim>(CellShape, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
