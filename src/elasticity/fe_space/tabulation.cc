#include "elasticity/fe_space/tabulation.h"

#include <array>

#include "elasticity/fe_space/simplex_tabulation.h"
#include "mesh/basis/cell_parts.h"
#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {
namespace {

using mesh::CellShape;

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
  return mesh::lexicographic_numbers<dim>(degree.plane);
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
  return tabulate_simplex<dim>(degree.plane, points);
}

template <int dim>
Tabulation tabulate_geometry(CellShape shape, Degree degree,
                             const ReferencePoints<dim>& points) {
  if (shape == CellShape::kTensor) {
    return tabulate_tensor<dim>(degree, points,
                                identity(size(degrees<dim>(degree))));
  }
  return tabulate_simplex<dim>(degree.plane, points);
}

template <int dim>
std::vector<int> displacement_places(CellShape shape, Degree degree) {
  const auto order =
      shape == CellShape::kTensor
          ? displacement_order<dim>(degree)
          : identity(static_cast<unsigned>(
                mesh::simplex_lattice<dim>(degree.plane).size()));
  return {order.begin(), order.end()};
}

template <int dim>
ReferencePoints<dim> displacement_support_points(CellShape shape,
                                                 Degree degree) {
  const auto points = geometry_support_points<dim>(shape, degree);
  if (shape == CellShape::kSimplex) return points;
  const auto order = displacement_order<dim>(degree);
  ReferencePoints<dim> result(dim, points.cols());
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.col(static_cast<Eigen::Index>(i)) = points.col(order[i]);
  }
  return result;
}

template <int dim>
ReferencePoints<dim> geometry_support_points(CellShape shape, Degree degree) {
  if (shape == CellShape::kSimplex) {
    return mesh::simplex_nodes<dim>(degree.plane);
  }
  const auto p = degrees<dim>(degree);
  std::array<Eigen::VectorXd, dim> along;
  for (unsigned d = 0; d < dim; ++d) along[d] = mesh::gauss_lobatto(p[d]);
  return tensor_points<dim>(along);
}

template <int dim>
Quadrature<dim> gauss(CellShape shape, Degree n) {
  if (shape == CellShape::kTensor) return gauss_tensor<dim>(n);
  if constexpr (dim > 1) return gauss_simplex<dim>(n.plane);
  return {};
}

template <int dim>
FaceQuadrature<dim> face_gauss(CellShape shape, int face, Degree n) {
  if (shape == CellShape::kSimplex) {
    return face_gauss_simplex<dim>(face, n.plane);
  }
  Quadrature<dim - 1> rule;
  if constexpr (dim == 3) {
    // The directions along the face: both in the plane, or the last is z.
    const bool is_lid = face / 2 == 2;
    rule = is_lid ? gauss<2>(shape, n.plane) : side_gauss(n);
  } else {
    rule = gauss<1>(shape, n.plane);
  }
  const auto size = rule.points.cols();
  FaceQuadrature<dim> result;
  result.points.resize(dim, size);
  result.weights = rule.weights;
  result.outward.setZero();
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

template <int dim>
ReferencePoints<dim> lattice(CellShape shape, int subdivisions) {
  if (shape == CellShape::kSimplex) return lattice_simplex<dim>(subdivisions);
  std::array<Eigen::VectorXd, dim> along;
  along.fill(Eigen::VectorXd::LinSpaced(subdivisions + 1, 0.0, 1.0));
  return tensor_points<dim>(along);
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template Tabulation tabulate_displacement<dim>(CellShape, Degree,            \
                                                 const ReferencePoints<dim>&); \
  template Tabulation tabulate_geometry<dim>(CellShape, Degree,                \
                                             const ReferencePoints<dim>&);     \
  template std::vector<int> displacement_places<dim>(CellShape, Degree);       \
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
