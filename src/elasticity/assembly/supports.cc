#include "elasticity/assembly/supports.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <fmt/format.h>

#include "base/algebra/singular_vectors.h"
#include "base/messages/errors.h"
#include "part/supports.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

template <int dim>
using Positions = Eigen::Matrix<double, dim, Eigen::Dynamic>;

template <int dim>
double extent(const Positions<dim>& positions) {
  return (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff())
      .norm();
}

/// A rigid mode in words: its axis, or the direction it slides.
template <int dim>
std::string describe_mode(const VectorXd& mode) {
  const auto text = [](double x, double y, double z) {
    return fmt::format("({:.3g}, {:.3g}, {:.3g})", x, y, z);
  };
  if constexpr (dim == 2) {
    if (std::abs(mode[2]) > 1e-6) return "rotation in the plane";
    return "translation along " + text(mode[0], mode[1], 0.0);
  } else {
    const Eigen::Vector3d turn = mode.tail<3>();
    if (turn.norm() > 1e-6) {
      const Eigen::Vector3d axis = turn.normalized();
      return "rotation about an axis along " + text(axis[0], axis[1], axis[2]);
    }
    const Eigen::Vector3d slide = mode.head<3>().normalized();
    return "translation along " + text(slide[0], slide[1], slide[2]);
  }
}

template <int dim>
MatrixXd rows_of(const MatrixXd& modes, const std::vector<int>& dofs) {
  MatrixXd rows(static_cast<Index>(dofs.size()), modes.cols());
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    rows.row(static_cast<Index>(k)) = modes.row(dofs[k]);
  }
  return rows;
}

template <int dim>
void require_held(const MatrixXd& modes, const std::vector<int>& held,
                  const FoundationStiffness<dim>* bed,
                  const std::string& place) {
  constexpr double kLoose = 1e-9;
  MatrixXd rows = MatrixXd::Zero(kRigidModes<dim>, kRigidModes<dim>);
  if (!held.empty()) {
    const MatrixXd at = rows_of<dim>(modes, held);
    rows = at.transpose() * at / static_cast<double>(held.size());
  }
  if (bed != nullptr && !bed->empty()) {
    const MatrixXd moved = bed->on_modes(modes);
    rows += moved / moved.trace();
  }
  const SingularVectors held_modes = singular_vectors(rows);
  std::string free;
  for (int k = 0; k < kRigidModes<dim>; ++k) {
    if (held_modes.sigma[k] > kLoose) continue;
    if (!free.empty()) free += "; ";
    free += describe_mode<dim>(held_modes.V.col(k));
  }
  if (free.empty()) return;
  throw Error(
      "F001", place, "the supports leave the part free: " + free,
      "Hold more components in `fixed`, give the foundation a tangential "
      "stiffness, or leave both out if the loads are in balance.");
}

}  // namespace

template <int dim>
Positions<dim> node_positions(const Discretization<dim>& discretization) {
  const auto support = displacement_support_points<dim>(
      discretization.shape, discretization.displacement_degree());
  const auto geometry = tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), support);
  Positions<dim> positions(dim, discretization.nodes);
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const Positions<dim> at =
        discretization.cell_points[c] * geometry.values.transpose();
    for (Index i = 0; i < at.cols(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      positions.col(discretization.cell_nodes[c][k]) = at.col(i);
    }
  }
  return positions;
}

template <int dim>
MatrixXd rigid_modes(const Positions<dim>& positions,
                     const Eigen::Matrix<double, dim, 1>& centre,
                     double length) {
  MatrixXd modes = MatrixXd::Zero(dim * positions.cols(), kRigidModes<dim>);
  for (Index i = 0; i < positions.cols(); ++i) {
    auto at = modes.middleRows<dim>(dim * i);
    at.template leftCols<dim>().setIdentity();
    const Eigen::Matrix<double, dim, 1> arm =
        (positions.col(i) - centre) / length;
    if constexpr (dim == 2) {
      at(0, 2) = -arm[1];
      at(1, 2) = arm[0];
    } else {
      for (int k = 0; k < 3; ++k) {
        at.col(3 + k) = Eigen::Vector3d::Unit(k).cross(arm);
      }
    }
  }
  return modes;
}

template <int dim>
std::vector<int> determinate_supports(const Discretization<dim>& discretization,
                                      const MatrixXd& modes,
                                      const std::vector<int>& held) {
  std::vector<int> candidates;
  for (int node : discretization.vertex_nodes) {
    for (int d = 0; d < dim && node >= 0; ++d) {
      if (!std::ranges::binary_search(held, dim * node + d)) {
        candidates.push_back(dim * node + d);
      }
    }
  }
  const MatrixXd rows = rows_of<dim>(modes, candidates);
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.transpose());
  std::vector<int> chosen;
  for (Index k = 0; k < modes.cols(); ++k) {
    const Index pivot = qr.colsPermutation().indices()[k];
    chosen.push_back(candidates[static_cast<std::size_t>(pivot)]);
  }
  std::ranges::sort(chosen);
  return chosen;
}

template <int dim>
std::vector<int> determinate_supports(const Discretization<dim>& discretization,
                                      const Positions<dim>& positions) {
  return determinate_supports<dim>(
      discretization,
      rigid_modes<dim>(positions, positions.rowwise().mean(),
                       extent<dim>(positions)),
      {});
}

template <int dim>
std::vector<int> held_on_groups(const Discretization<dim>& discretization,
                                const part::Supports& fixed) {
  std::vector<int> held;
  for (std::size_t g = 0; g < discretization.groups.size(); ++g) {
    const auto entry = fixed.find(discretization.groups[g].name);
    if (entry == fixed.end()) continue;
    for (int node : group_nodes(discretization, static_cast<int>(g))) {
      for (int d = 0; d < dim; ++d) {
        if (entry->second[static_cast<std::size_t>(d)]) {
          held.push_back(dim * node + d);
        }
      }
    }
  }
  std::ranges::sort(held);
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

template <int dim>
std::vector<int> fixed_supports(const Discretization<dim>& discretization,
                                const Positions<dim>& positions,
                                const part::Supports& fixed,
                                const std::string& place,
                                const FoundationStiffness<dim>* bed) {
  const std::vector<int> held = held_on_groups<dim>(discretization, fixed);
  const MatrixXd modes = rigid_modes<dim>(positions, positions.rowwise().mean(),
                                          extent<dim>(positions));
  require_held<dim>(modes, held, bed, place);
  return held;
}

#define CLEVIS_INSTANTIATE(dim)                                              \
  template Positions<dim> node_positions<dim>(const Discretization<dim>&);   \
  template MatrixXd rigid_modes<dim>(                                        \
      const Positions<dim>&, const Eigen::Matrix<double, dim, 1>&, double);  \
  template std::vector<int> determinate_supports<dim>(                       \
      const Discretization<dim>&, const Positions<dim>&);                    \
  template std::vector<int> determinate_supports<dim>(                       \
      const Discretization<dim>&, const MatrixXd&, const std::vector<int>&); \
  template std::vector<int> held_on_groups<dim>(const Discretization<dim>&,  \
                                                const part::Supports&);      \
  template std::vector<int> fixed_supports<dim>(                             \
      const Discretization<dim>&, const Positions<dim>&,                     \
      const part::Supports&, const std::string&,                             \
      const FoundationStiffness<dim>*);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
