#include "elasticity/holds/mean_motions.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/nodal_loads/seat_means.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// ∫ N dA of a group's surface per node [m²].
template <int dim>
VectorXd surface_weights(const Discretization<dim>& discretization,
                         const std::string& name) {
  const auto found =
      std::ranges::find(discretization.groups, name, &mesh::SurfaceGroup::name);
  FaceTables<dim> tables;
  const auto trace = group_trace(
      discretization, static_cast<int>(found - discretization.groups.begin()),
      tables);
  VectorXd weights = VectorXd::Zero(discretization.nodes);
  Index begin = 0;
  for (const auto& face : trace.faces) {
    const Index n = face.values->rows();
    const VectorXd areas =
        face.values->transpose() * trace.quadrature.weights.segment(begin, n);
    for (std::size_t k = 0; k < face.nodes.size(); ++k) {
      weights[face.nodes[k]] += areas[static_cast<Index>(k)];
    }
    begin += n;
  }
  return weights;
}

/// Middle of what is touched of a wall, from the seat's point along the wall
/// [m].
/// @param touched  positions of nodes there.
Vector3d middle_of(const Eigen::Matrix3Xd& touched, const loads::Seat& seat,
                   const loads::ContactZone& zone) {
  Vector3d middle = Vector3d::Zero();
  for (const Index k : {0, 1}) {
    const Vector3d& axis = k == 0 ? seat.slide->along_L : seat.slide->across_L;
    const VectorXd places = (touched.colwise() - seat.p_LS).transpose() * axis;
    const double low = std::max(zone.low[k], places.minCoeff());
    const double high = std::min(zone.high[k], places.maxCoeff());
    middle += 0.5 * (low + high) * axis;
  }
  return middle;
}

}  // namespace

template <int dim>
MatrixXd NodeFunctionals<dim>::of(const MatrixXd& u) const {
  MatrixXd here(rows.cols(), u.cols());
  for (Index column = 0; column < u.cols(); ++column) {
    for (Index k = 0; k < std::ssize(nodes); ++k) {
      here.col(column).template segment<dim>(dim * k) =
          u.col(column).template segment<dim>(
              dim * nodes[static_cast<std::size_t>(k)]);
    }
  }
  return product(rows, here);
}

template <int dim>
void NodeFunctionals<dim>::add(const MatrixXd& amounts,
                               MatrixXd& forces) const {
  const MatrixXd here = transposed_product(rows, amounts);
  for (Index column = 0; column < forces.cols(); ++column) {
    for (Index k = 0; k < std::ssize(nodes); ++k) {
      forces.col(column).template segment<dim>(
          dim * nodes[static_cast<std::size_t>(k)]) +=
          here.col(column).template segment<dim>(dim * k);
    }
  }
}

template <int dim>
NodeFunctionals<dim> mean_motions(const SurfaceLoads& of_unit_wrenches) {
  const auto& [nodes, values] = of_unit_wrenches;
  NodeFunctionals<dim> motions;
  std::vector<Index> touched;  // of a slide's wall
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto row = static_cast<Index>(dim * k);
    if (values.template middleRows<dim>(row).isZero(0.0)) continue;
    motions.nodes.push_back(nodes[k]);
    for (Index d = 0; d < dim; ++d) touched.push_back(row + d);
  }
  motions.rows = values(touched, Eigen::all).transpose();
  return motions;
}

template <int dim>
MeanMotions<dim>::MeanMotions(const Discretization<dim>& discretization)
    : discretization_(discretization),
      positions_(node_positions(discretization)),
      size_((positions_.rowwise().maxCoeff() - positions_.rowwise().minCoeff())
                .norm()),
      rigid_(rigid_modes<dim>(positions_, positions_.rowwise().mean(), size_)) {
}

template <int dim>
bool MeanMotions<dim>::has_faces(const std::string& group) const {
  return elasticity::has_faces(discretization_, group);
}

template <int dim>
const MeanMotion<dim>& MeanMotions<dim>::of_group(const std::string& group) {
  const auto known = of_groups_.find(group);
  if (known != of_groups_.end()) return known->second;
  return of_groups_
      .emplace(group, mean_motion(surface_weights<dim>(discretization_, group)))
      .first->second;
}

template <int dim>
const MeanMotion<dim>& MeanMotions<dim>::of_part() {
  if (!of_part_) of_part_ = mean_motion(node_volumes<dim>(discretization_));
  return *of_part_;
}

template <int dim>
MeanMotion<dim> MeanMotions<dim>::mean_motion(const VectorXd& weights) const {
  MeanMotion<dim> motion;
  for (Index node = 0; node < weights.size(); ++node) {
    if (weights[node] != 0.0) motion.of.nodes.push_back(node);
  }
  const VectorXd weighing = weights(motion.of.nodes);
  const Eigen::Matrix<double, dim, Eigen::Dynamic> places =
      positions_(Eigen::all, motion.of.nodes);
  motion.centre = places * weighing / weighing.sum();
  const MatrixXd modes = rigid_modes<dim>(places, motion.centre, 1.0);
  VectorXd of_dofs(modes.rows());
  for (Index node = 0; node < weighing.size(); ++node) {
    of_dofs.segment<dim>(dim * node).setConstant(weighing[node]);
  }
  const MatrixXd weighted = (of_dofs.asDiagonal() * modes).transpose();
  motion.of.rows = (weighted * modes).fullPivLu().solve(weighted);
  return motion;
}

template <int dim>
MeanMotion<dim> MeanMotions<dim>::of_touched(const TouchedSeats& touched,
                                             std::size_t s,
                                             const std::string& part_name) {
  constexpr Index kTurns = kRigidModes<dim> - dim;
  const loads::Seat& seat = touched.seats[s];
  const loads::ContactZone& zone = touched.zones[s];
  const std::pair walls(seat.group, seat.slide->opposite);
  auto wall = walls_.find(walls);
  if (wall == walls_.end()) {
    wall = walls_
               .emplace(std::piecewise_construct, std::forward_as_tuple(walls),
                        std::forward_as_tuple(discretization_, seat, part_name))
               .first;
  }
  MeanMotion<dim> motion;
  motion.of = mean_motions<dim>(seat_mean(wall->second, seat, {zone}));
  Eigen::Matrix3Xd at(3, std::ssize(motion.of.nodes));
  at.bottomRows(1).setConstant(discretization_.mid_plane_z);
  at.topRows(dim) = positions_(Eigen::all, motion.of.nodes);
  const Vector3d way = middle_of(at, seat, zone);
  motion.centre = (seat.p_LS + way).template head<dim>();
  for (Index k = 0; k < dim; ++k) {  // u + θ × way
    motion.of.rows.row(k) +=
        way.cross(Vector3d::Unit(k)).template tail<kTurns>().transpose() *
        motion.of.rows.template bottomRows<kTurns>();
  }
  return motion;
}

template NodeFunctionals<2> mean_motions<2>(const SurfaceLoads&);
template NodeFunctionals<3> mean_motions<3>(const SurfaceLoads&);
template struct NodeFunctionals<2>;
template struct NodeFunctionals<3>;
template class MeanMotions<2>;
template class MeanMotions<3>;

}  // namespace clevis::elasticity
