#include "mechanism/sampling/body_loads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "mechanism/definition/drive_names.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

std::vector<int> moving(std::initializer_list<int> bodies) {
  std::vector<int> result;
  for (const int body : bodies) {
    if (body != kGround && std::ranges::find(result, body) == result.end()) {
      result.push_back(body);
    }
  }
  return result;
}

const JointDefinition& joint_of(const MechanismDefinition& definition, int k) {
  return definition.joints[static_cast<std::size_t>(k)];
}

Vector3d in_frame_of(const Instant& instant, int body, const Vector3d& v_W) {
  const Pose& pose = instant.bodies[static_cast<std::size_t>(body)].pose;
  return pose.R_WL.transpose() * v_W;
}

}  // namespace

void BodyLoads::add(int count, std::vector<int> bodies, bool is_moment,
                    bool is_peak) {
  vectors_.push_back({size_, count, is_moment, is_peak, std::move(bodies)});
  size_ += count;
}

BodyLoads::BodyLoads(const MechanismDefinition& definition, double length)
    : definition_(definition), length_(length) {
  for (const JointDefinition& joint : definition.joints) {
    bool is_peak = true;  // the same length in both frames
    for (const int body : moving({joint.body_a, joint.body_b})) {
      add(3, {body}, false, is_peak);
      add(3, {body}, true, is_peak);
      is_peak = false;
    }
  }
  for (const DriveDefinition& drive : definition.drives) {
    const JointDefinition& joint = joint_of(definition, drive.joint);
    add(1, moving({joint.body_a, joint.body_b}),
        drives_angle(definition, drive), true);
  }
  for (const CouplingDefinition& coupling : definition.couplings) {
    const JointDefinition& one = joint_of(definition, coupling.joint_1);
    const JointDefinition& two = joint_of(definition, coupling.joint_2);
    add(1, moving({one.body_a, one.body_b, two.body_a, two.body_b}),
        coordinate_row(one.type, coupling.coordinate_1).is_angle(), true);
  }
  for (const ForceElement& element : definition.elements) {
    const auto [a, b] = bodies_of(element, definition.joints);
    add(2, {}, is_angle(element, definition.joints), true);
    for (const int body : {a, b}) {
      if (body == kGround) continue;
      add(3, {body}, false, false);
      add(3, {body}, true, false);
    }
  }
  for (int i = 0; i < static_cast<int>(definition.bodies.size()); ++i) {
    add(9, {i}, false, false);
  }
}

void BodyLoads::put_joints(const Instant& instant, VectorXd& values,
                           Index& at) const {
  for (std::size_t j = 0; j < definition_.joints.size(); ++j) {
    const JointDefinition& joint = definition_.joints[j];
    for (const int body : moving({joint.body_a, joint.body_b})) {
      const JointReaction& reaction = instant.joints[j];
      values.segment<3>(at) = in_frame_of(instant, body, reaction.f_W);
      values.segment<3>(at + 3) = in_frame_of(instant, body, reaction.t_W);
      at += 6;
    }
  }
}

/// Forces that turning needs in a body: m r ω ω, m r α.
void BodyLoads::put_inertia(const Instant& instant, VectorXd& values,
                            Index& at) const {
  for (std::size_t i = 0; i < definition_.bodies.size(); ++i) {
    const part::MassProperties& mass = definition_.bodies[i].mass_properties;
    const double arm = std::sqrt(mass.inertia_LCm.trace() * mass.mass);
    const int body = static_cast<int>(i);
    const Vector3d w = in_frame_of(instant, body, instant.bodies[i].w_WL);
    const Vector3d alpha =
        in_frame_of(instant, body, instant.bodies[i].alpha_WL);
    values.segment<3>(at) = arm * w.cwiseProduct(w);
    values.segment<3>(at + 3) =
        arm * Vector3d(w.x() * w.y(), w.y() * w.z(), w.z() * w.x());
    values.segment<3>(at + 6) = arm * alpha;
    at += 9;
  }
}

VectorXd BodyLoads::of(const Instant& instant) const {
  VectorXd values(size_);
  Index at = 0;
  put_joints(instant, values, at);
  for (const DriveState& drive : instant.drives) values[at++] = drive.effort;
  for (const CouplingState& coupling : instant.couplings) {
    values[at++] = coupling.effort;
  }
  for (const ElementState& element : instant.elements) {
    values[at++] = element.effort;
    values[at++] = element.friction;
    for (const ElementAction& action : element.actions) {
      if (action.body == kGround) continue;
      values.segment<3>(at) = in_frame_of(instant, action.body, action.f_W);
      values.segment<3>(at + 3) = in_frame_of(instant, action.body, action.t_W);
      at += 6;
    }
  }
  put_inertia(instant, values, at);
  return values;
}

VectorXd BodyLoads::lengths(const VectorXd& values) const {
  VectorXd result(static_cast<Index>(vectors_.size()));
  for (std::size_t v = 0; v < vectors_.size(); ++v) {
    result[static_cast<Index>(v)] =
        values.segment(vectors_[v].begin, vectors_[v].count).norm();
  }
  return result;
}

VectorXd BodyLoads::scales(const VectorXd& largest) const {
  constexpr double kPart = 1e-4;
  // by body: forces, and moments over the length
  std::vector<double> felt(definition_.bodies.size(), 0.0);
  for (std::size_t v = 0; v < vectors_.size(); ++v) {
    const double arm = vectors_[v].is_moment ? length_ : 1.0;
    for (const int body : vectors_[v].bodies) {
      double& most = felt[static_cast<std::size_t>(body)];
      most = std::max(most, largest[static_cast<Index>(v)] / arm);
    }
  }
  VectorXd scales = largest;
  for (std::size_t v = 0; v < vectors_.size(); ++v) {
    const double arm = vectors_[v].is_moment ? length_ : 1.0;
    for (const int body : vectors_[v].bodies) {
      double& scale = scales[static_cast<Index>(v)];
      scale =
          std::max(scale, kPart * arm * felt[static_cast<std::size_t>(body)]);
    }
  }
  return scales;
}

}  // namespace clevis::mechanism
