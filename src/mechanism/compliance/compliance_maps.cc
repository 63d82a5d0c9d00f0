#include "mechanism/compliance/compliance_maps.h"

#include <cstddef>

#include "base/values/index.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Index joint_components(const SolvingFrame& frame) {
  return 6 * static_cast<Index>(frame.joints.size());
}

/// Components per scaled multiplier, also those of drives.
MatrixXd all_components(const SolvingFrame& frame,
                        const ConstraintSystem& system,
                        const std::vector<PlacedJoint>& placed) {
  const Index joints = joint_components(frame);
  MatrixXd E = MatrixXd::Zero(
      joints + static_cast<Index>(frame.couplings.size()), system.rows());
  for (int i = 0; i < system.rows(); ++i) {
    const auto& row = system.row_list()[index(i)];
    if (row.coupling >= 0) {
      E(joints + row.coupling, i) = 1.0;
      continue;
    }
    const PlacedJoint& joint = placed[index(row.joint)];
    const SpatialForce action = joint.action(row.row);
    E.block<3, 1>(6 * row.joint, i) =
        system.scale(row) * (joint.axes_a.transpose() * action.v);
    E.block<3, 1>(6 * row.joint + 3, i) =
        system.scale(row) * (joint.axes_a.transpose() * action.w);
  }
  return E;
}

MatrixXd without_drives(const ConstraintSystem& system, MatrixXd by_row) {
  by_row.rightCols(system.rows() - system.joint_rows()).setZero();
  return by_row;
}

VectorXd compliances(const SolvingFrame& frame) {
  const Index joints = joint_components(frame);
  VectorXd c(joints + static_cast<Index>(frame.couplings.size()));
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    c.segment<6>(6 * static_cast<Index>(j)) = frame.joints[j].compliance;
  }
  c.tail(c.size() - joints).setConstant(kDefaultCompliance);
  return c;
}

/// Components of a joint → force and moment on the link at its point, in L.
Matrix6 wrench_on_link(const SolvingFrame& frame, const ElasticLink& link,
                       std::size_t k, const std::vector<PlacedJoint>& placed) {
  const JointModel& model = frame.joints[index(link.joints[k])];
  const PlacedJoint& joint = placed[index(link.joints[k])];
  const bool is_b = model.b == link.slot;
  const Matrix3d R_PL =
      is_b ? Matrix3d(joint.axes_b * model.frame_b.R_LJ.transpose())
           : Matrix3d(joint.axes_a * model.frame_a.R_LJ.transpose());
  const double sign = is_b ? 1.0 : -1.0;
  const Matrix3d R_LJ = sign * R_PL.transpose() * joint.axes_a;
  // from the point to J on b, where the components act
  const Vector3d lever =
      (is_b ? Vector3d::Zero() : Vector3d(R_PL.transpose() * joint.d)) -
      link.points[k];
  Matrix6 T = Matrix6::Zero();
  T.topLeftCorner<3, 3>() = T.bottomRightCorner<3, 3>() = R_LJ;
  for (int i = 0; i < 3; ++i) {
    T.block<3, 1>(3, i) = lever.cross(Vector3d(R_LJ.col(i)));
  }
  return T;
}

}  // namespace

ComplianceMaps compliance_maps(const SolvingFrame& frame,
                               const ConstraintSystem& system,
                               const std::vector<PlacedJoint>& placed) {
  ComplianceMaps result;
  const MatrixXd all = all_components(frame, system, placed);
  result.components = without_drives(system, all);
  result.compliance = compliances(frame);
  Index rows = all.rows();
  for (const ElasticLink& link : frame.links) rows += link.root.rows();
  result.energy_root.resize(rows, all.cols());
  result.energy_root.topRows(all.rows()) =
      result.compliance.cwiseSqrt().asDiagonal() * result.components;
  Index row = all.rows();
  for (const ElasticLink& link : frame.links) {
    result.link_rows.push_back(row);
    MatrixXd wrenches(link.root.cols(), all.cols());
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      wrenches.middleRows(6 * static_cast<Index>(k), 6) =
          wrench_on_link(frame, link, k, placed) *
          all.middleRows(6 * link.joints[k], 6);
    }
    result.energy_root.middleRows(row, link.root.rows()) = link.root * wrenches;
    row += link.root.rows();
  }
  result.link_rows.push_back(row);
  return result;
}

VectorXd strain_beside_joints(const ElasticLink& link, const Vector3d& spin,
                              const VectorXd& loads) {
  VectorXd strain = VectorXd::Zero(link.root.rows());
  if (link.spin_root.size() > 0) {
    Eigen::Matrix<double, 6, 1> products;
    products << spin.cwiseAbs2(), spin.x() * spin.y(), spin.x() * spin.z(),
        spin.y() * spin.z();
    strain += link.spin_root * products;
  }
  if (link.load_root.size() > 0) strain += link.load_root * loads;
  return strain;
}

MatrixXd components_of_rows(const SolvingFrame& frame,
                            const ConstraintSystem& system,
                            const std::vector<PlacedJoint>& placed) {
  return without_drives(system, all_components(frame, system, placed));
}

MatrixXd row_compliance(const SolvingFrame& frame,
                        const ConstraintSystem& system,
                        const std::vector<PlacedJoint>& placed) {
  const MatrixXd root = without_drives(
      system, compliance_maps(frame, system, placed).energy_root);
  return root.transpose() * root;
}

}  // namespace clevis::mechanism
