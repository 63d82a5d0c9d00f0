#include "stress/peaks/surroundings.h"

#include <cstddef>
#include <vector>

namespace clevis::stress {
namespace {

using Eigen::Index;

template <int dim>
bool is_inside(mesh::CellShape shape, const Eigen::Matrix<double, dim, 1>& xi) {
  if ((xi.array() < 0.0).any()) return false;
  return shape == mesh::CellShape::kSimplex ? xi.sum() <= 1.0
                                            : (xi.array() <= 1.0).all();
}

}  // namespace

template <int dim>
elasticity::ReferencePoints<dim> surroundings(
    mesh::CellShape shape, const Eigen::Matrix<double, dim, 1>& centre,
    double spacing) {
  std::vector<Eigen::Matrix<double, dim, 1>> inside = {centre};
  const int all = dim == 2 ? 9 : 27;
  for (int k = 0; k < all; ++k) {
    Eigen::Matrix<double, dim, 1> xi = centre;
    for (int d = 0, rest = k; d < dim; ++d, rest /= 3) {
      xi[d] += (rest % 3 - 1) * spacing;
    }
    if (is_inside<dim>(shape, xi)) inside.push_back(xi);
  }
  elasticity::ReferencePoints<dim> points(dim,
                                          static_cast<Index>(inside.size()));
  for (std::size_t i = 0; i < inside.size(); ++i) {
    points.col(static_cast<Index>(i)) = inside[i];
  }
  return points;
}

template elasticity::ReferencePoints<2> surroundings<2>(mesh::CellShape,
                                                        const Eigen::Vector2d&,
                                                        double);
template elasticity::ReferencePoints<3> surroundings<3>(mesh::CellShape,
                                                        const Eigen::Vector3d&,
                                                        double);

}  // namespace clevis::stress
