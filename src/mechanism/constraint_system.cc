#include "mechanism/constraint_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

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
                   .frame_b = joint.frame_b,
                   .slide_per_angle = joint.lead / (2.0 * std::numbers::pi),
                   .length = joint.length,
                   .counts_turns = joint.type == JointType::kScrew};
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
    if (drives_angle(definition, drive)) continue;
    length = std::max({length, std::abs(drive.from), std::abs(drive.to)});
    for (const double x : drive.table.values) {
      length = std::max(length, std::abs(x));
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
      if (joint.type == JointType::kDistance) continue;
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

/// Screws at the turn that their slide tells, the others within half a turn.
std::vector<double> first_angles(const SolvingFrame& frame) {
  std::vector<double> angles(frame.joints.size(), 0.0);
  for (std::size_t j = 0; j < angles.size(); ++j) {
    const JointModel& joint = frame.joints[j];
    if (joint.type != JointType::kScrew) continue;
    const PlacedJoint placed(joint, frame.placement[index(joint.a)],
                             frame.placement[index(joint.b)]);
    angles[j] = placed.displacement({JointRow::Kind::kTranslation, 2}) /
                joint.slide_per_angle;
  }
  return angles;
}

/// As given, or equal in all directions and, of moments, that over length².
void set_compliances(const MechanismDefinition& definition,
                     SolvingFrame& frame) {
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    auto& compliance = frame.joints[j].compliance;
    const double turn = kDefaultCompliance / (frame.length * frame.length);
    compliance << Vector3d::Constant(kDefaultCompliance),
        Vector3d::Constant(turn);
    if (const auto& given = definition.joints[j].compliance) {
      compliance << given->force, given->moment;
    }
  }
}

std::vector<ElasticLink> elastic_links(const MechanismDefinition& definition) {
  std::vector<ElasticLink> links;
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    const auto& given = definition.bodies[i].compliance;
    if (!given) continue;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(given->matrix);
    ElasticLink link{
        .slot = static_cast<int>(i) + 1,
        .joints = given->joints,
        .points = given->points,
        .root = modes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                modes.eigenvectors().transpose()};
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      const JointDefinition& joint = definition.joints[index(link.joints[k])];
      const bool is_b = joint.body_b == static_cast<int>(i);
      link.points[k] -= (is_b ? joint.frame_b : joint.frame_a).p_LJ;
    }
    links.push_back(std::move(link));
  }
  return links;
}

CouplingModel coupling_model(const CouplingDefinition& coupling,
                             SolvingFrame& frame) {
  JointModel& first = frame.joints[index(coupling.joint_1)];
  JointModel& second = frame.joints[index(coupling.joint_2)];
  CouplingModel model{
      .joint_1 = coupling.joint_1,
      .joint_2 = coupling.joint_2,
      .row_1 = coordinate_row(first.type, coupling.coordinate_1),
      .row_2 = coordinate_row(second.type, coupling.coordinate_2),
      .ratio = coupling.ratio};
  first.counts_turns = second.counts_turns = true;
  const double per_1 = model.row_1.is_angle() ? 1.0 / frame.length : 1.0;
  const double per_2 = model.row_2.is_angle() ? 1.0 / frame.length : 1.0;
  model.scale = 1.0 / std::hypot(per_1, coupling.ratio * per_2);
  const auto at_placement = [&frame](const JointModel& joint,
                                     const JointRow& row) {
    return PlacedJoint(joint, frame.placement[index(joint.a)],
                       frame.placement[index(joint.b)])
        .displacement(row);
  };
  model.offset = coupling.offset.value_or(
      at_placement(first, model.row_1) -
      coupling.ratio * at_placement(second, model.row_2));
  return model;
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
  placement.angles = first_angles(*this);
  set_compliances(definition, *this);
  links = elastic_links(definition);
  for (const CouplingDefinition& coupling : definition.couplings) {
    couplings.push_back(coupling_model(coupling, *this));
  }
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

void ConstraintSystem::add_levers(MatrixXd& J, int row, int joint,
                                  const PlacedJoint::Levers& levers,
                                  double factor) const {
  const int width = static_cast<int>(components_.size());
  const auto add = [&](int slot, const Twist& lever) {
    if (slot == 0) return;
    for (int k = 0; k < width; ++k) {
      const int component = components_[index(k)];
      J(row, (slot - 1) * width + k) +=
          factor * (component < 3 ? lever.v[component]
                                  : lever.w[component - 3] / length_);
    }
  };
  add(frame_->joints[index(joint)].a, levers.a);
  add(frame_->joints[index(joint)].b, levers.b);
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
    add_levers(J, i, r.joint, placed[index(r.joint)].levers(r.row), scale(r));
    if (r.coupling < 0) continue;
    const CouplingModel& k = frame_->couplings[coupling(r)];
    add_levers(J, i, k.joint_2, placed[index(k.joint_2)].levers(k.row_2),
               -k.scale * k.ratio);
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
