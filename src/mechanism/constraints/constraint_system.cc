#include "mechanism/constraints/constraint_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/values/index.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

}  // namespace

ConstraintSystem::ConstraintSystem(const SolvingFrame& frame,
                                   const std::vector<DriveDefinition>& drives,
                                   Motions motions, Drives with_drives)
    : frame_(&frame),
      motions_(motions),
      components_(twist_components(motions)),
      length_(frame.length) {
  columns_ =
      static_cast<int>((frame.placement.size() - 1) * components_.size());
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    for (const JointRow& row :
         constrained_rows(frame.joints[j].type, motions)) {
      rows_.push_back({static_cast<int>(j), row});
    }
  }
  if (motions != Motions::kOutOfPlane) {
    for (std::size_t k = 0; k < frame.couplings.size(); ++k) {
      const CouplingModel& coupling = frame.couplings[k];
      rows_.push_back({coupling.joint_1, coupling.row_1, static_cast<int>(k)});
    }
  }
  joint_rows_ = rows();
  if (with_drives == Drives::kNone) return;
  for (const DriveDefinition& drive : drives) {
    rows_.push_back(
        {drive.joint, coordinate_row(frame.joints[index(drive.joint)].type,
                                     drive.coordinate)});
  }
}

std::vector<PlacedJoint> ConstraintSystem::place(const Configuration& x) const {
  std::vector<PlacedJoint> placed;
  placed.reserve(frame_->joints.size());
  for (std::size_t j = 0; j < frame_->joints.size(); ++j) {
    const JointModel& joint = frame_->joints[j];
    placed.emplace_back(joint, x[index(joint.a)], x[index(joint.b)],
                        x.angle(j));
  }
  return placed;
}

void ConstraintSystem::place(const Configuration& x,
                             std::vector<PlacedJoint>& placed) const {
  for (std::size_t j = 0; j < placed.size(); ++j) {
    const JointModel& joint = frame_->joints[j];
    placed[j] =
        PlacedJoint(joint, x[index(joint.a)], x[index(joint.b)], x.angle(j));
  }
}

VectorXd ConstraintSystem::residual(const std::vector<PlacedJoint>& placed,
                                    const VectorXd& targets) const {
  VectorXd c(rows());
  residual(placed, targets, c);
  return c;
}

void ConstraintSystem::residual(const std::vector<PlacedJoint>& placed,
                                const VectorXd& targets, VectorXd& c) const {
  for (int i = 0; i < rows(); ++i) {
    const Row& r = rows_[index(i)];
    double gap = placed[index(r.joint)].displacement(r.row);
    if (r.coupling >= 0) {  // counts turns
      const CouplingModel& k = frame_->couplings[coupling(r)];
      gap -= k.ratio * placed[index(k.joint_2)].displacement(k.row_2);
      c[i] = k.scale * (gap - k.offset);
      continue;
    }
    if (i >= joint_rows_) gap -= targets[i - joint_rows_];
    if (r.row.is_angle()) {
      gap = length_ * std::remainder(gap, 2.0 * std::numbers::pi);
    }
    c[i] = gap;
  }
}

void ConstraintSystem::add_levers(MatrixXd& J, int row, int slot_a, int slot_b,
                                  const PlacedJoint::Levers& levers,
                                  double factor) const {
  const int width = static_cast<int>(components_.size());
  const auto add = [&](int slot, const SpatialForce& lever) {
    if (slot == 0) return;
    for (int k = 0; k < width; ++k) {
      const int component = components_[index(k)];
      J(row, (slot - 1) * width + k) +=
          factor * (component < 3 ? lever.v[component]
                                  : lever.w[component - 3] / length_);
    }
  };
  add(slot_a, levers.a);
  add(slot_b, levers.b);
}

MatrixXd ConstraintSystem::jacobian(
    const std::vector<PlacedJoint>& placed) const {
  MatrixXd J = MatrixXd::Zero(rows(), columns_);
  fill_jacobian(placed, J);
  return J;
}

void ConstraintSystem::fill_jacobian(const std::vector<PlacedJoint>& placed,
                                     MatrixXd& J) const {
  J.topRows(rows()).setZero();
  for (int i = 0; i < rows(); ++i) {
    const Row& r = rows_[index(i)];
    const JointModel& joint = frame_->joints[index(r.joint)];
    add_levers(J, i, joint.a, joint.b, placed[index(r.joint)].levers(r.row),
               scale(r));
    if (r.coupling < 0) continue;
    const CouplingModel& k = frame_->couplings[coupling(r)];
    const JointModel& second = frame_->joints[index(k.joint_2)];
    add_levers(J, i, second.a, second.b,
               placed[index(k.joint_2)].levers(k.row_2), -k.scale * k.ratio);
  }
}

VectorXd ConstraintSystem::bias(const std::vector<PlacedJoint>& placed,
                                const std::vector<Twist>& twists) const {
  VectorXd result(rows());
  bias(placed, twists, result);
  return result;
}

void ConstraintSystem::bias(const std::vector<PlacedJoint>& placed,
                            const std::vector<Twist>& twists,
                            VectorXd& bias) const {
  const auto of = [&](int joint, const JointRow& row) {
    const JointModel& model = frame_->joints[index(joint)];
    return placed[index(joint)].bias(row, twists[index(model.a)],
                                     twists[index(model.b)]);
  };
  for (int i = 0; i < rows(); ++i) {
    const Row& r = rows_[index(i)];
    bias[i] = of(r.joint, r.row);
    if (r.coupling >= 0) {
      const CouplingModel& k = frame_->couplings[coupling(r)];
      bias[i] -= k.ratio * of(k.joint_2, k.row_2);
    }
    bias[i] *= scale(r);
  }
}

std::vector<Twist> ConstraintSystem::twists(const VectorXd& unknowns) const {
  std::vector<Twist> result(frame_->placement.size());
  const int width = static_cast<int>(components_.size());
  for (int i = 0; i < columns_; ++i) {
    const int component = components_[index(i % width)];
    Twist& twist = result[index(1 + i / width)];
    if (component < 3) {
      twist.v[component] = unknowns[i];
    } else {
      twist.w[component - 3] = unknowns[i] / length_;
    }
  }
  return result;
}

VectorXd ConstraintSystem::wrench_vector(
    const std::vector<SpatialForce>& wrenches) const {
  VectorXd result(columns_);
  const int width = static_cast<int>(components_.size());
  for (int i = 0; i < columns_; ++i) {
    const int component = components_[index(i % width)];
    const SpatialForce& wrench = wrenches[index(1 + i / width)];
    result[i] =
        component < 3 ? wrench.v[component] : wrench.w[component - 3] / length_;
  }
  return result;
}

double ConstraintSystem::multiplier(const Row& row, double scaled) const {
  return scale(row) * scaled;
}

void ConstraintSystem::move(Configuration& x, const VectorXd& unknowns) const {
  const std::vector<Twist> steps = twists(unknowns);
  for (std::size_t i = 1; i < x.size(); ++i) x[i].move(steps[i].v, steps[i].w);
  for (std::size_t j = 0; j < x.angles.size(); ++j) {
    const JointModel& joint = frame_->joints[j];
    if (!joint.counts_turns) continue;
    const auto a = index(joint.a), b = index(joint.b);
    const Vector3d axis = x[a].R * joint.frame_a.R_LJ.col(2);
    const double about = x.angles[j] + axis.dot(steps[b].w - steps[a].w);
    x.angles[j] = PlacedJoint(joint, x[a], x[b], about).turned();
  }
}

double ConstraintSystem::distance(const Configuration& x,
                                  const Configuration& y) const {
  double largest = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    // chord of the turn: 2 |vec(q_x* q_y)|
    const double turn = 2.0 * (x[i].q.conjugate() * y[i].q).vec().norm();
    largest = std::max(largest, (x[i].p - y[i].p).norm() + length_ * turn);
  }
  return largest;
}

VectorXd ConstraintSystem::difference(const Configuration& x,
                                      const Configuration& y) const {
  std::vector<Twist> steps(x.size());
  for (std::size_t i = 1; i < x.size(); ++i) {
    steps[i].v = y[i].p - x[i].p;
    const Eigen::AngleAxisd turn(y[i].q * x[i].q.conjugate());
    const double angle = std::remainder(turn.angle(), 2.0 * std::numbers::pi);
    // wrench_vector() divides by the length, unknowns are multiplied by it
    steps[i].w = length_ * length_ * angle * turn.axis();
  }
  return wrench_vector(steps);
}

double largest_gap(const VectorXd& residual) {
  return residual.size() == 0 ? 0.0 : residual.cwiseAbs().maxCoeff();
}

}  // namespace clevis::mechanism
