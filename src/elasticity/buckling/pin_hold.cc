#include "elasticity/buckling/pin_hold.h"

#include <algorithm>
#include <iterator>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/nodal_loads/seat_means.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Centres nearer than this, over the part's size, have no line between them.
constexpr double kNearest = 1e-3;

/// ∫ N dA of a group's surface per node [m²].
VectorXd surface_weights(const Discretization<3>& discretization,
                         const std::string& name) {
  const auto found =
      std::ranges::find(discretization.groups, name, &mesh::SurfaceGroup::name);
  FaceTables<3> tables;
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

/// Mean displacement (three functionals) and mean rotation about the centre
/// (three more): the rigid motion nearest to the weighted displacements.
struct MeanMotion {
  Vector3d centre;
  NodeFunctionals of;
};
MeanMotion mean_motion(const Eigen::Matrix3Xd& positions,
                       const VectorXd& weights) {
  MeanMotion motion;
  for (Index node = 0; node < weights.size(); ++node) {
    if (weights[node] != 0.0) motion.of.nodes.push_back(node);
  }
  const VectorXd weighing = weights(motion.of.nodes);
  const Eigen::Matrix3Xd places = positions(Eigen::all, motion.of.nodes);
  motion.centre = places * weighing / weighing.sum();
  const MatrixXd modes = rigid_modes<3>(places, motion.centre, 1.0);
  VectorXd of_dofs(modes.rows());
  for (Index node = 0; node < weighing.size(); ++node) {
    of_dofs.segment<3>(3 * node).setConstant(weighing[node]);
  }
  const MatrixXd weighted = (of_dofs.asDiagonal() * modes).transpose();
  motion.of.rows = (weighted * modes).fullPivLu().solve(weighted);
  return motion;
}

/// That of what is touched of a seat, about the seat's point.
MeanMotion touched_motion(const Discretization<3>& discretization,
                          const TouchedSeats& touched, std::size_t s) {
  const MatrixXd columns =
      seat_means(discretization, {touched.seats[s]}, {touched.zones[s]}, "");
  MeanMotion motion;
  motion.centre = touched.seats[s].p_LS;
  motion.of = nodes_of(columns);
  return motion;
}

/// Six conditions, not scaled.
NodeFunctionals conditions(const Discretization<3>& discretization,
                           const Eigen::Matrix3Xd& positions,
                           const std::vector<std::string>& given,
                           const TouchedSeats* touched) {
  const auto motion_of = [&](const std::string& group) {
    if (touched != nullptr) {
      const auto seat =
          std::ranges::find_if(touched->seats, [&](const loads::Seat& one) {
            return one.group == group && one.slide.has_value();
          });
      if (seat != touched->seats.end()) {
        return touched_motion(
            discretization, *touched,
            static_cast<std::size_t>(seat - touched->seats.begin()));
      }
    }
    return mean_motion(positions, surface_weights(discretization, group));
  };
  std::vector<std::string> groups;
  std::ranges::copy_if(given, std::back_inserter(groups),
                       [&](const std::string& name) {
                         return has_faces(discretization, name);
                       });
  if (groups.empty()) {
    return mean_motion(positions, node_volumes<3>(discretization)).of;
  }
  auto first = motion_of(groups[0]);
  if (groups.size() == 1) return std::move(first.of);
  const auto second = motion_of(groups[1]);
  const Vector3d line = second.centre - first.centre;
  const double size =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  if (line.norm() <= kNearest * size) return std::move(first.of);
  const Vector3d along = line.normalized();
  const Vector3d across = along.unitOrthogonal();
  NodeFunctionals both{first.of.nodes, {}};
  std::ranges::copy(second.of.nodes, std::back_inserter(both.nodes));
  const Index dofs = first.of.rows.cols();
  both.rows = MatrixXd::Zero(6, dofs + second.of.rows.cols());
  auto of_first = both.rows.leftCols(dofs);
  auto of_second = both.rows.rightCols(second.of.rows.cols());
  of_first.topRows(3) = first.of.rows.topRows(3);
  of_second.row(3) = across.transpose() * second.of.rows.topRows(3);
  of_second.row(4) =
      along.cross(across).transpose() * second.of.rows.topRows(3);
  of_first.row(5) = along.transpose() * first.of.rows.bottomRows(3);
  return both;
}

}  // namespace

NodeFunctionals nodes_of(const MatrixXd& columns) {
  NodeFunctionals found;
  for (Index node = 0; 3 * node < columns.rows(); ++node) {
    if (!columns.middleRows<3>(3 * node).isZero(0.0)) {
      found.nodes.push_back(node);
    }
  }
  found.rows.resize(columns.cols(), 3 * std::ssize(found.nodes));
  for (Index k = 0; k < std::ssize(found.nodes); ++k) {
    const Index node = found.nodes[static_cast<std::size_t>(k)];
    found.rows.middleCols<3>(3 * k) =
        columns.middleRows<3>(3 * node).transpose();
  }
  return found;
}

MatrixXd NodeFunctionals::of(const MatrixXd& u) const {
  MatrixXd here(rows.cols(), u.cols());
  for (Index column = 0; column < u.cols(); ++column) {
    for (Index k = 0; k < std::ssize(nodes); ++k) {
      here.col(column).segment<3>(3 * k) =
          u.col(column).segment<3>(3 * nodes[static_cast<std::size_t>(k)]);
    }
  }
  return product(rows, here);
}

void NodeFunctionals::add(const MatrixXd& amounts, MatrixXd& forces) const {
  const MatrixXd here = transposed_product(rows, amounts);
  for (Index column = 0; column < forces.cols(); ++column) {
    for (Index k = 0; k < std::ssize(nodes); ++k) {
      forces.col(column).segment<3>(3 * nodes[static_cast<std::size_t>(k)]) +=
          here.col(column).segment<3>(3 * k);
    }
  }
}

PinHold::PinHold(const Discretization<3>& discretization,
                 const std::vector<std::string>& groups,
                 const TouchedSeats* touched) {
  const auto positions = node_positions(discretization);
  const double size =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  rigid_ = rigid_modes<3>(positions, positions.rowwise().mean(), size);
  conditions_ = conditions(discretization, positions, groups, touched);
  conditions_.rows =
      (conditions_.of(rigid_).fullPivLu().inverse() * conditions_.rows).eval();
}

MatrixXd PinHold::broken(const MatrixXd& u) const {
  return conditions_.of(u);
}

MatrixXd PinHold::project(const MatrixXd& u) const {
  return u - product(rigid_, broken(u));
}

MatrixXd PinHold::balance(const MatrixXd& f) const {
  MatrixXd balanced = f;
  conditions_.add(-transposed_product(rigid_, f), balanced);
  return balanced;
}

}  // namespace clevis::elasticity
