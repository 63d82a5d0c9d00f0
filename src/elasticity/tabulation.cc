#include "elasticity/tabulation.h"

#include <array>
#include <cassert>

#include <Eigen/Geometry>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_tools.h>

#include "mesh/tensor_basis.h"

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

template <int dim>
std::array<int, dim> degrees(Degree degree) {
  std::array<int, dim> result{};
  result.fill(degree.plane);
  if (dim == 3) result.back() = degree.thickness;
  return result;
}

template <std::size_t dim>
unsigned size(const std::array<int, dim>& degrees) {
  unsigned n = 1;
  for (const int p : degrees) n *= static_cast<unsigned>(p + 1);
  return n;
}

/// Lexicographic index of each function of the displacement basis.
template <int dim>
std::vector<unsigned> displacement_order(Degree degree) {
  if (dim == 3 && degree.plane != degree.thickness) {
    return identity(size(degrees<dim>(degree)));
  }
  return dealii::FETools::hierarchic_to_lexicographic_numbering<dim>(
      static_cast<unsigned>(degree.plane));
}

/// Calls f(index, digits) with the digits of every lexicographic index.
template <int dim, class Visitor>
void for_each(const std::array<int, static_cast<std::size_t>(dim)>& degrees,
              const Visitor& visit) {
  std::array<Eigen::Index, dim> digit{};
  const unsigned n = size(degrees);
  for (unsigned i = 0; i < n; ++i) {
    visit(i, digit);
    for (unsigned d = 0; d < dim && ++digit[d] > degrees[d]; ++d) digit[d] = 0;
  }
}

/// Products of 1-D Lagrange polynomials.
/// @param order  lexicographic index of each function.
template <int dim>
Tabulation tabulate_tensor(Degree degree, const ReferencePoints<dim>& points,
                           const std::vector<unsigned>& order) {
  const auto p = degrees<dim>(degree);
  std::array<mesh::LagrangeBasis, dim> line;
  for (unsigned d = 0; d < dim; ++d) {
    line[d] = mesh::lagrange(mesh::gauss_lobatto(p[d]), points.row(d));
  }
  std::vector<unsigned> function(order.size());
  for (unsigned i = 0; i < order.size(); ++i) function[order[i]] = i;
  Tabulation table;
  const auto n = static_cast<Eigen::Index>(order.size());
  table.values.resize(points.cols(), n);
  table.gradients.assign(dim, Eigen::MatrixXd(points.cols(), n));
  for_each<dim>(p, [&](unsigned index, const auto& digit) {
    const auto i = static_cast<Eigen::Index>(function[index]);
    table.values.col(i) = line[0].value.col(digit[0]);
    for (unsigned d = 1; d < dim; ++d) {
      table.values.col(i).array() *= line[d].value.col(digit[d]).array();
    }
    for (unsigned k = 0; k < dim; ++k) {
      auto gradient = table.gradients[k].col(i).array();
      gradient.setOnes();
      for (unsigned d = 0; d < dim; ++d) {
        gradient *=
            (d == k ? line[d].slope : line[d].value).col(digit[d]).array();
      }
    }
  });
  return table;
}

template <int dim>
ReferencePoints<dim> tensor_points(
    const std::array<Eigen::VectorXd, dim>& along) {
  std::array<int, dim> last{};
  for (unsigned d = 0; d < dim; ++d) {
    last[d] = static_cast<int>(along[d].size()) - 1;
  }
  ReferencePoints<dim> points(dim, static_cast<Eigen::Index>(size(last)));
  for_each<dim>(last, [&](unsigned index, const auto& digit) {
    for (unsigned d = 0; d < dim; ++d) points(d, index) = along[d][digit[d]];
  });
  return points;
}

template <int dim>
Quadrature<dim> gauss_tensor(Degree n) {
  const auto counts = degrees<dim>(n);
  std::array<mesh::Quadrature, dim> line;
  std::array<Eigen::VectorXd, dim> along;
  std::array<int, dim> last{};
  for (unsigned d = 0; d < dim; ++d) {
    line[d] = mesh::gauss(counts[d]);
    along[d] = line[d].points;
    last[d] = counts[d] - 1;
  }
  Quadrature<dim> rule;
  rule.points = tensor_points<dim>(along);
  rule.weights.setOnes(rule.points.cols());
  for_each<dim>(last, [&](unsigned index, const auto& digit) {
    for (unsigned d = 0; d < dim; ++d) {
      rule.weights[index] *= line[d].weights[digit[d]];
    }
  });
  return rule;
}

/// Rule on a side face of a plate's cell: along the plane, then upwards.
Quadrature<2> side_gauss(Degree n) {
  const mesh::Quadrature plane = mesh::gauss(n.plane);
  const mesh::Quadrature upright = mesh::gauss(n.thickness);
  Quadrature<2> rule;
  rule.points = tensor_points<2>({plane.points, upright.points});
  rule.weights =
      (plane.weights * upright.weights.transpose()).reshaped().eval();
  return rule;
}

}  // namespace

template <int dim>
Tabulation tabulate_displacement(CellShape shape, Degree degree,
                                 const ReferencePoints<dim>& points) {
  if (shape == CellShape::kTensor) {
    return tabulate_tensor<dim>(degree, points,
                                displacement_order<dim>(degree));
  }
  const dealii::FE_SimplexP<dim> fe(static_cast<unsigned>(degree.plane));
  return tabulate<dim>(fe, points, identity(fe.n_dofs_per_cell()));
}

template <int dim>
Tabulation tabulate_geometry(CellShape shape, Degree degree,
                             const ReferencePoints<dim>& points) {
  if (shape == CellShape::kTensor) {
    return tabulate_tensor<dim>(degree, points,
                                identity(size(degrees<dim>(degree))));
  }
  assert(degree.plane == 1 && "simplices carry their vertices only");
  const dealii::FE_SimplexP<dim> fe(1);
  return tabulate<dim>(fe, points, identity(fe.n_dofs_per_cell()));
}

template <int dim>
ReferencePoints<dim> displacement_support_points(CellShape shape,
                                                 Degree degree) {
  if (shape == CellShape::kTensor) {
    const auto points = geometry_support_points<dim>(shape, degree);
    const auto order = displacement_order<dim>(degree);
    ReferencePoints<dim> result(dim, points.cols());
    for (std::size_t i = 0; i < order.size(); ++i) {
      result.col(static_cast<Eigen::Index>(i)) = points.col(order[i]);
    }
    return result;
  }
  const auto points =
      dealii::FE_SimplexP<dim>(static_cast<unsigned>(degree.plane))
          .get_unit_support_points();
  ReferencePoints<dim> result(dim, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (unsigned d = 0; d < dim; ++d) {
      result(d, static_cast<Eigen::Index>(i)) = points[i][d];
    }
  }
  return result;
}

template <int dim>
ReferencePoints<dim> geometry_support_points(CellShape shape, Degree degree) {
  if (shape == CellShape::kSimplex) {
    return displacement_support_points<dim>(shape, degree);
  }
  const auto p = degrees<dim>(degree);
  std::array<Eigen::VectorXd, dim> along;
  for (unsigned d = 0; d < dim; ++d) along[d] = mesh::gauss_lobatto(p[d]);
  return tensor_points<dim>(along);
}

template <int dim>
Quadrature<dim> gauss(CellShape shape, Degree n) {
  if (shape == CellShape::kTensor) return gauss_tensor<dim>(n);
  const dealii::QGaussSimplex<dim> rule(static_cast<unsigned>(n.plane));
  const auto points = static_cast<Eigen::Index>(rule.size());
  Quadrature<dim> result{ReferencePoints<dim>(dim, points),
                         Eigen::VectorXd(points)};
  for (Eigen::Index q = 0; q < points; ++q) {
    const auto index = static_cast<unsigned>(q);
    for (unsigned d = 0; d < dim; ++d) {
      result.points(d, q) = rule.point(index)[d];
    }
    result.weights[q] = rule.weight(index);
  }
  return result;
}

template <int dim>
FaceQuadrature<dim> face_gauss(CellShape shape, int face, Degree n) {
  Quadrature<dim - 1> rule;
  if constexpr (dim == 3) {
    // The directions along the face: both in the plane, or the last is z.
    const bool is_lid = shape == CellShape::kSimplex || face / 2 == 2;
    rule = is_lid ? gauss<2>(shape, n.plane) : side_gauss(n);
  } else {
    rule = gauss<1>(shape, n.plane);
  }
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
  template Tabulation tabulate_displacement<dim>(CellShape, Degree,            \
                                                 const ReferencePoints<dim>&); \
  template Tabulation tabulate_geometry<dim>(CellShape, Degree,                \
                                             const ReferencePoints<dim>&);     \
  template ReferencePoints<dim> displacement_support_points<dim>(CellShape,    \
                                                                 Degree);      \
  template ReferencePoints<dim> geometry_support_points<dim>(CellShape,        \
                                                             Degree);          \
  template Quadrature<dim> gauss<dim>(CellShape, Degree);                      \
  template FaceQuadrature<dim> face_gauss<dim>(CellShape, int, Degree);        \
  template ReferencePoints<dim> lattice<dim>(CellShape, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
