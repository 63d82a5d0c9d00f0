#include "elasticity/fe_space/cell_interpolation.h"

#include <optional>
#include <utility>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/fe_space/tabulation.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Coordinates of each direction of a tensor grid, first direction fastest;
/// nothing where the points are none.
template <int dim>
std::optional<std::array<VectorXd, dim>> grid_of(
    const ReferencePoints<dim>& points) {
  std::array<VectorXd, dim> along;
  Index stride = 1;  // from a point to its neighbour in this direction
  for (int d = 0; d < dim; ++d) {
    Index count = 1;
    while (count * stride < points.cols() &&
           points(d, count * stride) != points(d, 0)) {
      ++count;
    }
    auto& coordinates = along[static_cast<std::size_t>(d)];
    coordinates.resize(count);
    for (Index i = 0; i < count; ++i) coordinates[i] = points(d, i * stride);
    stride *= count;
  }
  if (stride != points.cols()) return std::nullopt;
  for (Index q = 0; q < points.cols(); ++q) {
    Index rest = q;
    for (int d = 0; d < dim; ++d) {
      const auto& coordinates = along[static_cast<std::size_t>(d)];
      if (points(d, q) != coordinates[rest % coordinates.size()]) {
        return std::nullopt;
      }
      rest /= coordinates.size();
    }
  }
  return along;
}

/// One direction of a tensor with `left` numbers inside it: from nodes to
/// points.
MatrixXd along_direction(const MatrixXd& basis, const MatrixXd& tensor,
                         Index left) {
  const Index right = tensor.size() / (left * basis.cols());
  if (left == 1) {
    return product(basis, tensor.reshaped(basis.cols(), right));
  }
  MatrixXd result(left * basis.rows(), right);
  mesh::contract(tensor.data(), basis, result.data(), left, right);
  return result;
}

}  // namespace

template <int dim>
CellInterpolation<dim>::CellInterpolation(mesh::CellShape shape, Degree degree,
                                          const ReferencePoints<dim>& points)
    : points_(points.cols()) {
  if (shape == mesh::CellShape::kTensor && points.cols() > 0) {
    if (const auto along = grid_of<dim>(points)) {
      is_grid_ = true;
      for (std::size_t d = 0; d < dim; ++d) {
        const int p = dim == 3 && d == 2 ? degree.thickness : degree.plane;
        auto line = mesh::lagrange(mesh::gauss_lobatto(p), (*along)[d]);
        value_[d] = std::move(line.value);
        slope_[d] = std::move(line.slope);
      }
      return;
    }
  }
  const auto table = tabulate_geometry<dim>(shape, degree, points);
  values_ = table.values;
  slopes_.resize(dim * points_, values_.cols());
  for (Index d = 0; d < dim; ++d) {
    slopes_.middleRows(d * points_, points_) =
        table.gradients[static_cast<std::size_t>(d)];
  }
}

template <int dim>
MatrixXd CellInterpolation<dim>::values(const MatrixXd& nodal) const {
  if (!is_grid_) return product(values_, nodal);
  MatrixXd tensor = along_direction(value_[0], nodal, 1);
  Index left = value_[0].rows();
  for (std::size_t d = 1; d < dim; ++d) {
    tensor = along_direction(value_[d], tensor, left);
    left *= value_[d].rows();
  }
  return tensor.reshaped(points_, nodal.cols());
}

template <int dim>
MatrixXd CellInterpolation<dim>::gradients(const MatrixXd& nodal) const {
  if (!is_grid_) return product(slopes_, nodal);
  MatrixXd result(dim * points_, nodal.cols());
  const auto put = [&](Index direction, const MatrixXd& tensor) {
    result.middleRows(direction * points_, points_) =
        tensor.reshaped(points_, nodal.cols());
  };
  const MatrixXd value = along_direction(value_[0], nodal, 1);
  const MatrixXd slope = along_direction(slope_[0], nodal, 1);
  const Index nx = value_[0].rows();
  const auto in_y = [&](const MatrixXd& basis, const MatrixXd& tensor) {
    return along_direction(basis, tensor, nx);
  };
  if constexpr (dim == 2) {
    put(0, in_y(value_[1], slope));
    put(1, in_y(slope_[1], value));
  } else {
    const auto in_z = [&](const MatrixXd& basis, const MatrixXd& tensor) {
      return along_direction(basis, tensor, nx * value_[1].rows());
    };
    put(0, in_z(value_[2], in_y(value_[1], slope)));
    put(1, in_z(value_[2], in_y(slope_[1], value)));
    put(2, in_z(slope_[2], in_y(value_[1], value)));
  }
  return result;
}

template class CellInterpolation<2>;
template class CellInterpolation<3>;

}  // namespace clevis::elasticity
