#include "elasticity/mirror_symmetry/mirror.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace clevis::elasticity {
namespace {

using Eigen::Index;

template <int dim>
using Positions = Eigen::Matrix<double, dim, Eigen::Dynamic>;

constexpr double kTolerance = 1e-9;  // of the size

/// Finds nodes by position: sorted by their coordinate along a direction in
/// which hardly two nodes coincide.
template <int dim>
class NodeFinder {
 public:
  NodeFinder(const Positions<dim>& positions, double tolerance)
      : positions_(positions), tolerance_(tolerance) {
    direction_ = Eigen::Vector3d(0.5698, 0.7549, 0.3247).head<dim>();
    for (Index i = 0; i < positions.cols(); ++i) {
      sorted_.emplace_back(direction_.dot(positions.col(i)),
                           static_cast<int>(i));
    }
    std::ranges::sort(sorted_);
  }

  /// The node at a point; nothing if there is none, or more than one.
  std::optional<int> at(const Eigen::Matrix<double, dim, 1>& point) const {
    const double along = direction_.dot(point);
    auto it = std::ranges::lower_bound(sorted_,
                                       std::pair(along - 2.0 * tolerance_, -1));
    std::optional<int> found;
    for (; it != sorted_.end() && it->first < along + 2.0 * tolerance_; ++it) {
      if ((positions_.col(it->second) - point).norm() > tolerance_) continue;
      if (found) return std::nullopt;
      found = it->second;
    }
    return found;
  }

 private:
  const Positions<dim>& positions_;
  double tolerance_;
  Eigen::Matrix<double, dim, 1> direction_;
  std::vector<std::pair<double, int>> sorted_;
};

/// Whether the image of every cell is another cell.
template <int dim>
bool pairs_cells(const Discretization<dim>& discretization,
                 const std::vector<int>& partner) {
  std::map<std::vector<int>, int> cell_of;
  for (int c = 0; c < discretization.cells(); ++c) {
    auto nodes = discretization.cell_nodes[static_cast<std::size_t>(c)];
    std::ranges::sort(nodes);
    cell_of.emplace(std::move(nodes), c);
  }
  for (const auto& [nodes, cell] : cell_of) {
    std::vector<int> image;
    for (int i : nodes) image.push_back(partner[static_cast<std::size_t>(i)]);
    std::ranges::sort(image);
    const auto found = cell_of.find(image);
    if (found == cell_of.end() || found->second == cell) return false;
  }
  return true;
}

template <int dim>
std::optional<Mirror> find_mirror(const Discretization<dim>& discretization,
                                  const Positions<dim>& positions,
                                  const NodeFinder<dim>& finder, int axis,
                                  double tolerance) {
  const auto row = positions.row(axis);
  Mirror mirror{axis, 0.5 * (row.minCoeff() + row.maxCoeff()), tolerance, {}};
  for (Index i = 0; i < positions.cols(); ++i) {
    Eigen::Matrix<double, dim, 1> image = positions.col(i);
    image[axis] = 2.0 * mirror.position - image[axis];
    const bool on_plane =
        std::abs(image[axis] - positions(axis, i)) < tolerance;
    const auto node = on_plane ? static_cast<int>(i) : finder.at(image);
    if (!node) return std::nullopt;
    mirror.partner.push_back(*node);
  }
  for (std::size_t i = 0; i < mirror.partner.size(); ++i) {
    const auto image = static_cast<std::size_t>(mirror.partner[i]);
    if (mirror.partner[image] != static_cast<int>(i)) return std::nullopt;
  }
  if (!pairs_cells(discretization, mirror.partner)) return std::nullopt;
  return mirror;
}

}  // namespace

template <int dim>
std::vector<Mirror> find_mirrors(const Discretization<dim>& discretization,
                                 const Positions<dim>& positions) {
  const double size =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  const double tolerance = kTolerance * size;
  const NodeFinder<dim> finder(positions, tolerance);
  std::vector<Mirror> mirrors;
  for (int axis = 0; axis < dim; ++axis) {
    auto mirror =
        find_mirror<dim>(discretization, positions, finder, axis, tolerance);
    if (mirror) mirrors.push_back(std::move(*mirror));
  }
  return mirrors;
}

template <int dim>
bool maps_to_itself(const Mirror& mirror, const std::vector<int>& dofs) {
  return std::ranges::all_of(dofs, [&](int dof) {
    const int image =
        dim * mirror.partner[static_cast<std::size_t>(dof / dim)] + dof % dim;
    return std::ranges::binary_search(dofs, image);
  });
}

template std::vector<Mirror> find_mirrors<2>(const Discretization<2>&,
                                             const Positions<2>&);
template std::vector<Mirror> find_mirrors<3>(const Discretization<3>&,
                                             const Positions<3>&);
template bool maps_to_itself<2>(const Mirror&, const std::vector<int>&);
template bool maps_to_itself<3>(const Mirror&, const std::vector<int>&);

}  // namespace clevis::elasticity
