#include "mechanism/constraint_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanism/plane.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

std::vector<Vector3d> reference_points(const MechanismDefinition& definition) {
  std::vector<Vector3d> sum(definition.bodies.size(), Vector3d::Zero());
  std::vector<int> count(definition.bodies.size(), 0);
  for (const JointDefinition& joint : definition.joints) {
    const auto add = [&](BodyIndex body, const JointFrame& frame) {
      if (body == kGround) return;
      sum[index(body)] += frame.p_LJ;
      ++count[index(body)];
    };
    add(joint.body_a, joint.frame_a);
    add(joint.body_b, joint.frame_b);
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (count[i] > 0) sum[i] /= count[i];
  }
  return sum;
}

JointModel joint_model(const JointDefinition& joint, const Matrix3d& R_WP,
                       const std::vector<Vector3d>& p_LM) {
  JointModel model{.type = joint.type,
                   .a = joint.body_a + 1,
                   .b = joint.body_b + 1,
                   .frame_a = joint.frame_a,
                   .frame_b = joint.frame_b};
  const auto refer = [&](BodyIndex body, JointFrame& frame) {
    if (body == kGround) {  // W → P
      frame.p_LJ = R_WP.transpose() * frame.p_LJ;
      frame.R_LJ = R_WP.transpose() * frame.R_LJ;
    } else {
      frame.p_LJ -= p_LM[index(body)];
    }
  };
  refer(joint.body_a, model.frame_a);
  refer(joint.body_b, model.frame_b);
  return model;
}

double link_length(const MechanismDefinition& definition,
                   const SolvingFrame& frame) {
  double length = 0.0;
  for (const JointModel& joint : frame.joints) {
    if (joint.a > 0) length = std::max(length, joint.frame_a.p_LJ.norm());
    if (joint.b > 0) length = std::max(length, joint.frame_b.p_LJ.norm());
  }
  for (const DriveDefinition& drive : definition.drives) {
    if (definition.joints[index(drive.joint)].type == JointType::kPrismatic) {
      length = std::max({length, std::abs(drive.from), std::abs(drive.to)});
    }
  }
  if (length > 0.0) return length;
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    length = std::max(
        length,
        (definition.bodies[i].mass_properties.p_LCm - frame.p_LM[i]).norm());
  }
  return length > 0.0 ? length : 1.0;
}

/// Shifts the bodies of a planar mechanism along the normal until the joints
/// meet, from ground outwards; motion in the plane does not change this.
void close_out_of_plane(SolvingFrame& frame) {
  std::vector<bool> seen(frame.placement.size(), false);
  seen[0] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const JointModel& joint : frame.joints) {
      if (seen[index(joint.a)] == seen[index(joint.b)]) continue;
      const PlacedJoint placed(joint, frame.placement[index(joint.a)],
                               frame.placement[index(joint.b)]);
      const bool shift_b = seen[index(joint.a)];
      frame.placement[index(shift_b ? joint.b : joint.a)].p.z() +=
          shift_b ? -placed.d.z() : placed.d.z();
      seen[index(joint.a)] = seen[index(joint.b)] = grown = true;
    }
  }
}

}  // namespace

SolvingFrame::SolvingFrame(const MechanismDefinition& given) {
  MechanismDefinition definition = given;
  if (const auto plane = find_plane(definition)) {
    planar = true;
    R_WP = *plane;
    align_joint_frames(definition, R_WP.col(2));
  }
  p_LM = reference_points(definition);
  for (const JointDefinition& joint : definition.joints) {
    joints.push_back(joint_model(joint, R_WP, p_LM));
  }
  length = link_length(definition, *this);
  placement.resize(definition.bodies.size() + 1);
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    const Pose& pose = definition.bodies[i].placement;
    BodyPlacement& body = placement[i + 1];
    body.p = R_WP.transpose() * (pose.p_WL + pose.R_WL * p_LM[i]);
    body.q = Eigen::Quaterniond(R_WP.transpose() * pose.R_WL).normalized();
    body.R = body.q.toRotationMatrix();
  }
  if (planar) close_out_of_plane(*this);
}

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
  joint_rows_ = rows();
  if (with_drives == Drives::kNone) return;
  for (const DriveDefinition& drive : drives) {
    rows_.push_back(
        {drive.joint, coordinate_row(frame.joints[index(drive.joint)].type)});
  }
}

std::vector<PlacedJoint> ConstraintSystem::place(const Configuration& x) const {
  std::vector<PlacedJoint> placed;
  placed.reserve(frame_->joints.size());
  for (const JointModel& joint : frame_->joints) {
    placed.emplace_back(joint, x[index(joint.a)], x[index(joint.b)]);
  }
  return placed;
}

VectorXd ConstraintSystem::residual(const std::vector<PlacedJoint>& placed,
                                    const VectorXd& targets) const {
  VectorXd c(rows());
  for (int i = 0; i < rows(); ++i) {
    const Row& r = rows_[index(i)];
    double gap = placed[index(r.joint)].displacement(r.row);
    if (i >= joint_rows_) gap -= targets[i - joint_rows_];
    if (r.row.kind == JointRow::Kind::kRotation) {
      gap = length_ * std::remainder(gap, 2.0 * std::numbers::pi);
    }
    c[i] = gap;
  }
  return c;
}

MatrixXd ConstraintSystem::jacobian(
    const std::vector<PlacedJoint>& placed) const {
  MatrixXd J = MatrixXd::Zero(rows(), columns_);
  const int width = static_cast<int>(components_.size());
  for (int i = 0; i < rows(); ++i) {
    const Row& r = rows_[index(i)];
    const auto levers = placed[index(r.joint)].levers(r.row);
    const double turn = scale(r.row) / length_;
    const auto fill = [&](int slot, const Twist& lever) {
      if (slot == 0) return;
      for (int k = 0; k < width; ++k) {
        const int component = components_[index(k)];
        J(i, (slot - 1) * width + k) =
            component < 3 ? lever.v[component] : turn * lever.w[component - 3];
      }
    };
    fill(frame_->joints[index(r.joint)].a, levers.a);
    fill(frame_->joints[index(r.joint)].b, levers.b);
  }
  return J;
}

VectorXd ConstraintSystem::bias(const std::vector<PlacedJoint>& placed,
                                const std::vector<Twist>& twists) const {
  VectorXd bias(rows());
  for (int i = 0; i < rows(); ++i) {
    const Row& r = rows_[index(i)];
    const JointModel& joint = frame_->joints[index(r.joint)];
    bias[i] = scale(r.row) *
              placed[index(r.joint)].bias(r.row, twists[index(joint.a)],
                                          twists[index(joint.b)]);
  }
  return bias;
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
    const std::vector<Twist>& wrenches) const {
  VectorXd result(columns_);
  const int width = static_cast<int>(components_.size());
  for (int i = 0; i < columns_; ++i) {
    const int component = components_[index(i % width)];
    const Twist& wrench = wrenches[index(1 + i / width)];
    result[i] =
        component < 3 ? wrench.v[component] : wrench.w[component - 3] / length_;
  }
  return result;
}

double ConstraintSystem::multiplier(const Row& row, double scaled) const {
  return scale(row.row) * scaled;
}

void ConstraintSystem::move(Configuration& x, const VectorXd& unknowns) const {
  const std::vector<Twist> steps = twists(unknowns);
  for (std::size_t i = 1; i < x.size(); ++i) x[i].move(steps[i].v, steps[i].w);
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

double largest_gap(const VectorXd& residual) {
  return residual.size() == 0 ? 0.0 : residual.cwiseAbs().maxCoeff();
}

}  // namespace clevis::mechanism
