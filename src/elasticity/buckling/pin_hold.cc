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

/// Mean displacement (three rows) and mean rotation about the centre (three
/// more), 6 × dofs: the rigid motion nearest to the weighted displacements.
struct MeanMotion {
  Vector3d centre;
  MatrixXd rows;
};
MeanMotion mean_motion(const Eigen::Matrix3Xd& positions,
                       const VectorXd& weights) {
  MeanMotion motion;
  motion.centre = positions * weights / weights.sum();
  const MatrixXd modes = rigid_modes<3>(positions, motion.centre, 1.0);
  VectorXd of_dofs(modes.rows());
  for (Index node = 0; node < weights.size(); ++node) {
    of_dofs.segment<3>(3 * node).setConstant(weights[node]);
  }
  const MatrixXd weighted = (of_dofs.asDiagonal() * modes).transpose();
  motion.rows = (weighted * modes).fullPivLu().solve(weighted);
  return motion;
}

/// That of what is touched of a seat, about the seat's point.
MeanMotion touched_motion(const Discretization<3>& discretization,
                          const TouchedSeats& touched, std::size_t s) {
  return {touched.seats[s].p_LS,
          seat_means(discretization, {touched.seats[s]}, {touched.zones[s]}, "")
              .transpose()};
}

/// Six conditions, not scaled.
MatrixXd conditions(const Discretization<3>& discretization,
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
    return mean_motion(positions, node_volumes<3>(discretization)).rows;
  }
  const auto first = motion_of(groups[0]);
  if (groups.size() == 1) return first.rows;
  const auto second = motion_of(groups[1]);
  const Vector3d line = second.centre - first.centre;
  const double size =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  if (line.norm() <= kNearest * size) return first.rows;
  const Vector3d along = line.normalized();
  const Vector3d across = along.unitOrthogonal();
  MatrixXd rows(6, first.rows.cols());
  rows.topRows(3) = first.rows.topRows(3);
  rows.row(3) = across.transpose() * second.rows.topRows(3);
  rows.row(4) = along.cross(across).transpose() * second.rows.topRows(3);
  rows.row(5) = along.transpose() * first.rows.bottomRows(3);
  return rows;
}

}  // namespace

PinHold::PinHold(const Discretization<3>& discretization,
                 const std::vector<std::string>& groups,
                 const TouchedSeats* touched) {
  const auto positions = node_positions(discretization);
  const double size =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  rigid_ = rigid_modes<3>(positions, positions.rowwise().mean(), size);
  const MatrixXd rows = conditions(discretization, positions, groups, touched);
  conditions_ = product(rows, rigid_).fullPivLu().inverse() * rows;
}

MatrixXd PinHold::broken(const MatrixXd& u) const {
  return product(conditions_, u);
}

MatrixXd PinHold::project(const MatrixXd& u) const {
  return u - product(rigid_, broken(u));
}

MatrixXd PinHold::balance(const MatrixXd& f) const {
  return f - transposed_product(conditions_, transposed_product(rigid_, f));
}

}  // namespace clevis::elasticity
