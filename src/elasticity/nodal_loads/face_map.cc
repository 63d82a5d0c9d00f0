#include "elasticity/nodal_loads/face_map.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/simplex_quadrature.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// A local face as an affine image of its own coordinates.
template <int dim>
struct FaceFrame {
  Eigen::Matrix<double, dim, 1> origin, outward;
  Eigen::Matrix<double, dim, dim - 1> edges;

  /// From three (two) of the points of its rule, which are affine images too.
  FaceFrame(mesh::CellShape shape, int face) {
    const auto rule = face_gauss<dim>(shape, face, 2);
    outward = rule.outward;
    const auto own = own_points(shape);
    constexpr std::array<Index, 3> kApart = {0, 1, 2};
    Eigen::Matrix<double, dim - 1, dim - 1> from;
    Eigen::Matrix<double, dim, dim - 1> to;
    for (Index k = 0; k < dim - 1; ++k) {
      const Index q = kApart[static_cast<std::size_t>(k + 1)];
      from.col(k) = own.col(q) - own.col(0);
      to.col(k) = rule.points.col(q) - rule.points.col(0);
    }
    edges = to * from.inverse();
    origin = rule.points.col(0) - edges * own.col(0);
  }

  ReferencePoints<dim> at(const FacePoints<dim>& own) const {
    return (edges * own).colwise() + origin;
  }

  double sense() const {
    if constexpr (dim == 2) {
      return outward.dot(Eigen::Vector2d(edges(1, 0), -edges(0, 0))) > 0.0
                 ? 1.0
                 : -1.0;
    } else {
      return outward.dot(edges.col(0).cross(edges.col(1))) > 0.0 ? 1.0 : -1.0;
    }
  }

 private:
  static FacePoints<dim> own_points(mesh::CellShape shape) {
    if constexpr (dim == 3) {
      if (shape == mesh::CellShape::kSimplex) {
        return mesh::simplex_gauss<2>(2).points;
      }
      const Eigen::VectorXd g = mesh::gauss(2).points;
      Eigen::Matrix2Xd points(2, 4);
      points << g[0], g[1], g[0], g[1], g[0], g[0], g[1], g[1];
      return points;
    } else {
      return mesh::gauss(2).points.transpose();
    }
  }
};

}  // namespace

template <int dim>
FaceBasis<dim>::FaceBasis(const Discretization<dim>& discretization, int face)
    : shape_(discretization.shape),
      degree_(std::max(discretization.displacement_degree().highest(),
                       discretization.mapping_degree().highest())),
      nodes_(mesh::gauss_lobatto(degree_)) {
  constexpr double kVanishes = 1e-10;
  const FaceFrame<dim> frame(shape_, face);
  sense_ = frame.sense();
  const FacePoints<dim> own = support_points();
  const ReferencePoints<dim> points = frame.at(own);
  const auto polynomials = values(own).partialPivLu();
  const MatrixXd displacement =
      tabulate_displacement<dim>(shape_, discretization.displacement_degree(),
                                 points)
          .values;
  for (Index i = 0; i < displacement.cols(); ++i) {
    if (displacement.col(i).cwiseAbs().maxCoeff() < kVanishes) continue;
    functions_.push_back(static_cast<std::size_t>(i));
  }
  MatrixXd living(displacement.rows(), static_cast<Index>(functions_.size()));
  for (std::size_t k = 0; k < functions_.size(); ++k) {
    living.col(static_cast<Index>(k)) =
        displacement.col(static_cast<Index>(functions_[k]));
  }
  displacement_ = polynomials.solve(living);
  geometry_ = polynomials.solve(
      tabulate_geometry<dim>(shape_, discretization.mapping_degree(), points)
          .values);
}

template <int dim>
FacePoints<dim> FaceBasis<dim>::support_points() const {
  if constexpr (dim == 2) {
    return nodes_.transpose();
  } else {
    return geometry_support_points<2>(shape_, degree_);
  }
}

template <int dim>
typename FaceBasis<dim>::Table FaceBasis<dim>::at(
    const FacePoints<dim>& own) const {
  if constexpr (dim == 2) {
    auto line = mesh::lagrange(nodes_, own.transpose());
    return {std::move(line.value), {std::move(line.slope)}};
  } else {
    if (shape_ == mesh::CellShape::kSimplex) {
      auto table = mesh::bernstein<2>(degree_, own);
      return {std::move(table.value),
              {std::move(table.slope[0]), std::move(table.slope[1])}};
    }
    const auto first = mesh::lagrange(nodes_, own.row(0));
    const auto second = mesh::lagrange(nodes_, own.row(1));
    const Index n = nodes_.size();
    const MatrixXd empty(own.cols(), n * n);
    Table table{empty, {empty, empty}};
    for (Index j = 0; j < n; ++j) {
      for (Index i = 0; i < n; ++i) {
        const Index k = i + n * j;
        table.value.col(k) =
            first.value.col(i).cwiseProduct(second.value.col(j));
        table.slope[0].col(k) =
            first.slope.col(i).cwiseProduct(second.value.col(j));
        table.slope[1].col(k) =
            first.value.col(i).cwiseProduct(second.slope.col(j));
      }
    }
    return table;
  }
}

template <int dim>
MatrixXd FaceBasis<dim>::values(const FacePoints<dim>& own) const {
  return at(own).value;
}

template <int dim>
FaceMap<dim>::FaceMap(const Discretization<dim>& discretization,
                      const FaceBasis<dim>& basis, int cell)
    : basis_(&basis), thickness_(discretization.thickness) {
  const auto& nodes =
      discretization.cell_points[static_cast<std::size_t>(cell)];
  coefficients_.resize(3, basis.geometry().rows());
  coefficients_.template topRows<dim>() = nodes * basis.geometry().transpose();
  if constexpr (dim == 2) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(nodes.cols());
    coefficients_.row(2) =
        discretization.mid_plane_z * (basis.geometry() * ones).transpose();
  }
}

template <int dim>
Eigen::Matrix3Xd FaceMap<dim>::points(const FacePoints<dim>& own) const {
  return coefficients_ * basis_->values(own).transpose();
}

template <int dim>
typename FaceMap<dim>::Surface FaceMap<dim>::surface(
    const typename FaceBasis<dim>::Table& table) const {
  Surface surface;
  surface.points = coefficients_ * table.value.transpose();
  const double factor = basis_->sense() * thickness_;
  const Eigen::Matrix3Xd along = coefficients_ * table.slope[0].transpose();
  surface.areas.resize(3, along.cols());
  if constexpr (dim == 2) {
    for (Index q = 0; q < along.cols(); ++q) {
      surface.areas.col(q) = factor * Vector3d(along(1, q), -along(0, q), 0.0);
    }
  } else {
    const Eigen::Matrix3Xd across = coefficients_ * table.slope[1].transpose();
    for (Index q = 0; q < along.cols(); ++q) {
      const Vector3d first = along.col(q), second = across.col(q);
      surface.areas.col(q) = factor * first.cross(second);
    }
  }
  return surface;
}

template class FaceBasis<2>;
template class FaceBasis<3>;
template class FaceMap<2>;
template class FaceMap<3>;

}  // namespace clevis::elasticity
