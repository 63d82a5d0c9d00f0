#include "elasticity/buckling/pin_hold.h"

#include <algorithm>
#include <iterator>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

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

/// That of what is touched of a seat, about its middle.
MeanMotion touched_motion(const Discretization<3>& discretization,
                          const Eigen::Matrix3Xd& positions,
                          const TouchedSeats& touched, std::size_t s,
                          const std::string& part_name) {
  const loads::Seat& seat = touched.seats[s];
  MeanMotion motion;
  motion.of = nodes_of(
      seat_means(discretization, {seat}, {touched.zones[s]}, part_name));
  const Vector3d way =
      middle_of(positions(Eigen::all, motion.of.nodes), seat, touched.zones[s]);
  motion.centre = seat.p_LS + way;
  for (Index k = 0; k < 3; ++k) {  // u + θ × way
    motion.of.rows.row(k) +=
        way.cross(Vector3d::Unit(k)).transpose() * motion.of.rows.bottomRows(3);
  }
  return motion;
}

/// Functionals one after another.
void append(const NodeFunctionals& more, NodeFunctionals& all) {
  const Index rows = all.rows.rows(), columns = all.rows.cols();
  std::ranges::copy(more.nodes, std::back_inserter(all.nodes));
  all.rows.conservativeResize(std::max(rows, more.rows.rows()),
                              columns + more.rows.cols());
  all.rows.rightCols(more.rows.cols()) = more.rows;
}

/// Conditions of a part.
class Conditions {
 public:
  Conditions(const Discretization<3>& discretization,
             const Eigen::Matrix3Xd& positions, const HoldingSeats& hold,
             const std::string& part_name)
      : discretization_(discretization),
        positions_(positions),
        hold_(hold),
        part_name_(part_name) {}

  /// Six, not scaled.
  NodeFunctionals of_groups() const {
    std::vector<std::string> groups;
    std::ranges::copy_if(hold_.groups, std::back_inserter(groups),
                         [&](const std::string& name) {
                           return has_faces(discretization_, name);
                         });
    if (groups.empty()) {
      return mean_motion(positions_, node_volumes<3>(discretization_)).of;
    }
    auto first = motion_of(groups[0]);
    if (groups.size() == 1) return std::move(first.of);
    const auto second = motion_of(groups[1]);
    const Vector3d line = second.centre - first.centre;
    const double size =
        (positions_.rowwise().maxCoeff() - positions_.rowwise().minCoeff())
            .norm();
    if (line.norm() <= kNearest * size) return std::move(first.of);
    const Vector3d along = line.normalized();
    const Vector3d across = along.unitOrthogonal();
    MatrixXd of_first = MatrixXd::Zero(6, first.of.rows.cols());
    MatrixXd of_second = MatrixXd::Zero(6, second.of.rows.cols());
    of_first.topRows(3) = first.of.rows.topRows(3);
    of_second.row(3) = across.transpose() * second.of.rows.topRows(3);
    of_second.row(4) =
        along.cross(across).transpose() * second.of.rows.topRows(3);
    of_first.row(5) = along.transpose() * first.of.rows.bottomRows(3);
    NodeFunctionals both{first.of.nodes, std::move(of_first)};
    append({second.of.nodes, std::move(of_second)}, both);
    return both;
  }

  /// As many as there are columns of wrenches.
  NodeFunctionals of_wrenches() const {
    NodeFunctionals all;
    for (const loads::GroupHold& held : hold_.held) {
      if (!has_faces(discretization_, held.group)) continue;
      const MeanMotion motion = motion_of(held.group);
      const Vector3d from_point = motion.centre - held.p_LS;
      MatrixXd about_centre = held.wrenches;
      for (Index k = 0; k < about_centre.cols(); ++k) {
        const Vector3d force = held.wrenches.col(k).head<3>();
        about_centre.col(k).tail<3>() -= from_point.cross(force);
      }
      append({motion.of.nodes, about_centre.transpose() * motion.of.rows}, all);
    }
    return all;
  }

 private:
  MeanMotion motion_of(const std::string& group) const {
    if (hold_.touched) {
      const auto& seats = hold_.touched->seats;
      const auto seat =
          std::ranges::find_if(seats, [&](const loads::Seat& one) {
            return one.group == group && one.slide.has_value();
          });
      if (seat != seats.end()) {
        return touched_motion(discretization_, positions_, *hold_.touched,
                              static_cast<std::size_t>(seat - seats.begin()),
                              part_name_);
      }
    }
    return mean_motion(positions_, surface_weights(discretization_, group));
  }

  const Discretization<3>& discretization_;
  const Eigen::Matrix3Xd& positions_;
  const HoldingSeats& hold_;
  const std::string& part_name_;
};

/// Of unit effect on rigid motions.
NodeFunctionals scaled(NodeFunctionals conditions, const MatrixXd& rigid) {
  conditions.rows =
      (conditions.of(rigid).fullPivLu().inverse() * conditions.rows).eval();
  return conditions;
}

/// Those of the wrenches that rigid motions feel most; what they do not feel is
/// held by the groups' conditions, of unit effect.
NodeFunctionals felt(NodeFunctionals wrenches, const NodeFunctionals& groups,
                     const MatrixXd& rigid) {
  constexpr double kFeels = 1e-4;  // of what is felt most
  const Eigen::JacobiSVD<MatrixXd> svd(
      wrenches.of(rigid), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const VectorXd& sigma = svd.singularValues();
  const Index n = (sigma.array() > kFeels * sigma[0]).count();
  NodeFunctionals all{wrenches.nodes, MatrixXd::Zero(6, wrenches.rows.cols())};
  all.rows.topRows(n) = svd.matrixU().leftCols(n).transpose() * wrenches.rows;
  MatrixXd rest = MatrixXd::Zero(6, groups.rows.cols());
  rest.bottomRows(6 - n) =
      svd.matrixV().rightCols(6 - n).transpose() * groups.rows;
  append({groups.nodes, std::move(rest)}, all);
  return all;
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
                 const HoldingSeats& hold, const std::string& part_name,
                 const PinHold* other) {
  const auto positions = node_positions(discretization);
  const double size =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  rigid_ = other != nullptr ? other->rigid_
                            : std::make_shared<MatrixXd>(rigid_modes<3>(
                                  positions, positions.rowwise().mean(), size));
  const Conditions conditions(discretization, positions, hold, part_name);
  conditions_ = scaled(conditions.of_groups(), *rigid_);
  NodeFunctionals held = conditions.of_wrenches();
  if (held.rows.rows() == 0) return;
  if (hold.with_all) all_ = held;
  conditions_ = scaled(felt(std::move(held), conditions_, *rigid_), *rigid_);
}

MatrixXd PinHold::broken(const MatrixXd& u) const {
  return conditions_.of(u);
}

MatrixXd PinHold::project(const MatrixXd& u) const {
  return u - product(*rigid_, broken(u));
}

MatrixXd PinHold::balance(const MatrixXd& f) const {
  MatrixXd balanced = f;
  conditions_.add(-transposed_product(*rigid_, f), balanced);
  return balanced;
}

MatrixXd PinHold::beyond() const {
  MatrixXd forces = MatrixXd::Zero(rigid_->rows(), all_.rows.rows());
  if (forces.cols() == 0) return forces;
  all_.add(MatrixXd::Identity(forces.cols(), forces.cols()), forces);
  return balance(forces);
}

}  // namespace clevis::elasticity
