#include "stress/displacement/held_reference.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "loads/history/motion_instants.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Seats nearer than this, over the part's size, have no line between them to
/// speak of: their slip over the distance would be a turn of any size.
constexpr double kNearestSeats = 1e-3;

/// Mean displacement and mean rotation of a surface group per basis column.
template <int dim>
struct SurfaceMotion {
  Eigen::Matrix<double, dim, 1> centre;  ///< [m]
  MatrixXd translation;                  ///< dim × rank [m]
  MatrixXd rotation;                     ///< 1 or 3 × rank [rad]
};

using NodeWeights = std::map<int, double>;

/// Area ∫ N dA that belongs to each node of a group [m²].
template <int dim>
NodeWeights surface_weights(
    const elasticity::Discretization<dim>& discretization,
    const std::string& name) {
  const auto& groups = discretization.groups;
  const auto found = std::ranges::find(groups, name, &mesh::SurfaceGroup::name);
  elasticity::FaceTables<dim> tables;
  const auto trace = elasticity::group_trace(
      discretization, static_cast<int>(found - groups.begin()), tables);
  NodeWeights weights;
  Index begin = 0;
  for (const auto& face : trace.faces) {
    const Index n = face.values->rows();
    const Eigen::VectorXd areas =
        face.values->transpose() * trace.quadrature.weights.segment(begin, n);
    for (std::size_t k = 0; k < face.nodes.size(); ++k) {
      weights[face.nodes[k]] += areas[static_cast<Index>(k)];
    }
    begin += n;
  }
  return weights;
}

/// Volume ∫ N dV that belongs to each node [m³]: the mean does not depend on
/// where the mesh is fine.
template <int dim>
NodeWeights volume_weights(
    const elasticity::Discretization<dim>& discretization) {
  const Eigen::VectorXd volumes = elasticity::node_volumes<dim>(discretization);
  NodeWeights weights;
  for (Index node = 0; node < volumes.size(); ++node) {
    weights[static_cast<int>(node)] = volumes[node];
  }
  return weights;
}

/// Rigid motion nearest to the displacements of nodes, about their centre.
template <int dim>
SurfaceMotion<dim> mean_motion(
    const elasticity::DisplacementBasis<dim>& basis,
    const NodeWeights& node_weights,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions) {
  const auto n = static_cast<Index>(node_weights.size());
  Eigen::Matrix<double, dim, Eigen::Dynamic> at(dim, n);
  MatrixXd u(dim * n, basis.columns.cols());
  Eigen::VectorXd weights(dim * n);
  Index k = 0;
  for (const auto& [node, weight] : node_weights) {
    at.col(k) = positions.col(node);
    u.middleRows<dim>(dim * k) =
        basis.columns.template middleRows<dim>(dim * node);
    weights.segment<dim>(dim * k).setConstant(weight);
    ++k;
  }
  SurfaceMotion<dim> motion;
  motion.centre = Eigen::Matrix<double, dim, 1>::Zero();
  double total = 0.0;
  for (Index i = 0; i < n; ++i) {
    motion.centre += weights[dim * i] * at.col(i);
    total += weights[dim * i];
  }
  motion.centre /= total;
  const MatrixXd modes = elasticity::rigid_modes<dim>(at, motion.centre, 1.0);
  const MatrixXd weighted = weights.asDiagonal() * modes;
  const MatrixXd fit = (weighted.transpose() * modes)
                           .fullPivLu()
                           .solve(weighted.transpose() * u);
  motion.translation = fit.topRows<dim>();
  motion.rotation = fit.bottomRows(elasticity::kRigidModes<dim> - dim);
  return motion;
}

/// Rotation that keeps the second centre on the line; about the line itself
/// the first surface's own.
template <int dim>
MatrixXd line_rotation(const SurfaceMotion<dim>& first,
                       const SurfaceMotion<dim>& second) {
  const Eigen::Matrix<double, dim, 1> line = second.centre - first.centre;
  const MatrixXd relative = second.translation - first.translation;
  if constexpr (dim == 2) {
    const Eigen::RowVector2d normal(-line[1], line[0]);
    return normal * relative / line.squaredNorm();
  } else {
    const Eigen::Vector3d d = line.normalized();
    MatrixXd rotation = d * (d.transpose() * first.rotation);
    for (Index k = 0; k < relative.cols(); ++k) {
      const Eigen::Vector3d slip = relative.col(k);
      rotation.col(k) += line.cross(slip) / line.squaredNorm();
    }
    return rotation;
  }
}

/// Rigid motions that a hold takes out of the columns of a basis.
template <int dim>
class HeldMotion {
 public:
  explicit HeldMotion(const elasticity::DisplacementBasis<dim>& basis)
      : basis_(basis),
        positions_(elasticity::node_positions(basis.discretization)),
        origin_(positions_.rowwise().mean()),
        size_(
            (positions_.rowwise().maxCoeff() - positions_.rowwise().minCoeff())
                .norm()) {}

  /// About the nodes' mean, of like size; dofs × motions.
  MatrixXd modes() const {
    return elasticity::rigid_modes<dim>(positions_, origin_, size_);
  }

  /// Amounts of modes(), motions × columns of the basis.
  MatrixXd of(const loads::PartHold& hold) {
    const MatrixXd by_groups = of_groups(hold.groups);
    std::vector<const loads::GroupHold*> held;
    for (const loads::GroupHold& one : hold.held) {
      if (elasticity::has_faces(basis_.discretization, one.group)) {
        held.push_back(&one);
      }
    }
    if (held.empty() || held.front()->wrenches.cols() == 0) return by_groups;
    const Index conditions = held.front()->wrenches.cols();
    MatrixXd of_modes = MatrixXd::Zero(conditions, kModes);
    MatrixXd of_columns = MatrixXd::Zero(conditions, by_groups.cols());
    for (const loads::GroupHold* one : held) {
      const SurfaceMotion<dim>& motion = of_group(one->group);
      const MatrixXd wrenches = about(motion.centre, *one);
      of_columns += wrenches.transpose() * stacked(motion);
      of_modes += wrenches.transpose() * of_modes_at(motion.centre);
    }
    return solved(of_modes, of_columns, by_groups);
  }

 private:
  static constexpr Index kModes = elasticity::kRigidModes<dim>;
  using Point = Eigen::Matrix<double, dim, 1>;

  const SurfaceMotion<dim>& of_group(const std::string& group) {
    const auto found = motions_.find(group);
    if (found != motions_.end()) return found->second;
    return motions_
        .emplace(group,
                 mean_motion<dim>(
                     basis_, surface_weights<dim>(basis_.discretization, group),
                     positions_))
        .first->second;
  }

  static MatrixXd stacked(const SurfaceMotion<dim>& motion) {
    MatrixXd both(kModes, motion.translation.cols());
    both << motion.translation, motion.rotation;
    return both;
  }

  /// Displacement and turn at a centre, of each mode.
  MatrixXd of_modes_at(const Point& centre) const {
    MatrixXd motions(kModes, kModes);
    motions << elasticity::rigid_modes<dim>(centre, origin_, size_),
        MatrixXd::Zero(kModes - dim, dim),
        MatrixXd::Identity(kModes - dim, kModes - dim) / size_;
    return motions;
  }

  /// Wrenches about a centre as they act on a displacement and a turn there.
  static MatrixXd about(const Point& centre, const loads::GroupHold& hold) {
    Eigen::Vector3d from_point = Eigen::Vector3d::Zero();
    from_point.head<dim>() = centre - hold.p_LS.head<dim>();
    MatrixXd wrenches(kModes, hold.wrenches.cols());
    for (Index k = 0; k < wrenches.cols(); ++k) {
      const Eigen::Vector3d force = hold.wrenches.col(k).head<3>();
      const Eigen::Vector3d moment =
          hold.wrenches.col(k).tail<3>() - from_point.cross(force);
      wrenches.col(k) << force.head<dim>(), moment.tail<kModes - dim>();
    }
    return wrenches;
  }

  MatrixXd of_groups(const loads::HoldingGroups& groups) {
    std::vector<std::string> seats;
    std::ranges::copy_if(
        groups, std::back_inserter(seats), [&](const std::string& name) {
          return elasticity::has_faces(basis_.discretization, name);
        });
    const SurfaceMotion<dim> first =
        seats.empty() ? mean_motion<dim>(
                            basis_, volume_weights<dim>(basis_.discretization),
                            positions_)
                      : of_group(seats.front());
    MatrixXd rotation = first.rotation;
    if (seats.size() > 1) {
      const SurfaceMotion<dim>& second = of_group(seats[1]);
      if ((second.centre - first.centre).norm() > kNearestSeats * size_) {
        rotation = line_rotation<dim>(first, second);
      }
    }
    MatrixXd motion(kModes, rotation.cols());
    motion.bottomRows(kModes - dim) = size_ * rotation;
    motion.topRows(dim) =
        first.translation -
        elasticity::rigid_modes<dim>(first.centre, origin_, size_)
                .rightCols(kModes - dim) *
            motion.bottomRows(kModes - dim);
    return motion;
  }

  /// By as many combinations of conditions as the modes feel; what they do not
  /// feel is as the groups have it.
  static MatrixXd solved(const MatrixXd& of_modes, const MatrixXd& of_columns,
                         const MatrixXd& by_groups) {
    constexpr double kFeels = 1e-4;  // of what is felt most
    const Eigen::JacobiSVD<MatrixXd> svd(
        of_modes, Eigen::ComputeThinU | Eigen::ComputeFullV);
    const Eigen::VectorXd& sigma = svd.singularValues();
    const Index n = (sigma.array() > kFeels * sigma[0]).count();
    const MatrixXd felt = svd.matrixV().leftCols(n);
    const MatrixXd rest = svd.matrixV().rightCols(kModes - n);
    return felt * (sigma.head(n).cwiseInverse().asDiagonal() *
                   (svd.matrixU().leftCols(n).transpose() * of_columns)) +
           rest * (rest.transpose() * by_groups);
  }

  const elasticity::DisplacementBasis<dim>& basis_;
  Eigen::Matrix<double, dim, Eigen::Dynamic> positions_;
  Point origin_;
  double size_;
  std::map<std::string, SurfaceMotion<dim>> motions_;  ///< by group
};

/// Of the motion's instants; none where all are alike.
std::vector<loads::PartHold> changing_holds(
    const loads::LoadHistory& history, const loads::HoldingGroups& groups) {
  constexpr std::size_t kLooks = 16;
  const std::size_t motion = loads::motion_length(history);
  if (!history.hold || motion < 2) return {};
  const auto hold = [&](std::size_t i) {
    return loads::hold_at(history, groups, history.instants[i].time);
  };
  const auto first = loads::hold_at(history, groups, history.hold_time);
  const auto is_other = [&](const loads::PartHold& here) {
    return here.groups != first.groups ||
           !loads::are_alike(here.held, first.held);
  };
  bool changes = false;
  for (std::size_t k = 0; k <= kLooks && !changes; ++k) {
    changes = is_other(hold(k * (motion - 1) / kLooks));
  }
  std::vector<loads::PartHold> holds;
  for (std::size_t i = 0; i < motion && changes; ++i) holds.push_back(hold(i));
  return holds;
}

}  // namespace

template <int dim>
void remove_rigid_motion(elasticity::DisplacementBasis<dim>& basis,
                         const loads::PartHold& hold) {
  HeldMotion<dim> motion(basis);
  basis.columns -= elasticity::product(motion.modes(), motion.of(hold));
}

template <int dim>
void refer_to_instants(const loads::LoadHistory& history,
                       const loads::HoldingGroups& groups,
                       elasticity::DisplacementBasis<dim>& basis) {
  constexpr Index kModes = elasticity::kRigidModes<dim>;
  const Index rank = basis.columns.cols();
  const auto holds = changing_holds(history, groups);
  if (holds.empty() || rank == 0 || basis.discretization.is_revolved) return;
  HeldMotion<dim> motion(basis);
  MatrixXd moved = MatrixXd::Zero(kModes, basis.coefficients.cols());
  for (std::size_t i = 0; i < holds.size(); ++i) {
    const auto at = static_cast<Index>(i);
    moved.col(at) = -motion.of(holds[i]) * basis.coefficients.col(at);
  }
  const MatrixXd modes = motion.modes();
  basis.columns.conservativeResize(Eigen::NoChange, rank + kModes);
  basis.columns.rightCols(kModes) = modes;
  basis.coefficients.conservativeResize(rank + kModes, Eigen::NoChange);
  basis.coefficients.bottomRows(kModes) = moved;
  basis.is_mirrored = false;
}

template void remove_rigid_motion<2>(elasticity::DisplacementBasis<2>&,
                                     const loads::PartHold&);
template void remove_rigid_motion<3>(elasticity::DisplacementBasis<3>&,
                                     const loads::PartHold&);
template void refer_to_instants<2>(const loads::LoadHistory&,
                                   const loads::HoldingGroups&,
                                   elasticity::DisplacementBasis<2>&);
template void refer_to_instants<3>(const loads::LoadHistory&,
                                   const loads::HoldingGroups&,
                                   elasticity::DisplacementBasis<3>&);

}  // namespace clevis::stress
