#include "mechanism/constraints/solving_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/values/index.h"
#include "mechanism/constraints/plane.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/definition/meshing_wheels.h"
#include "mechanism/joints/joint_types.h"
#include "numerics/factors/jacobian_factor.h"
#include "part/gyration.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

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
                   .counts_turns = traits(joint.type).counts_turns};
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

/// Whether no joint closes a loop.
bool forms_tree(const SolvingFrame& frame) {
  std::vector<int> group(frame.placement.size());
  std::iota(group.begin(), group.end(), 0);
  for (const JointModel& joint : frame.joints) {
    const int a = group[index(joint.a)], b = group[index(joint.b)];
    if (a == b) return false;
    std::ranges::replace(group, b, a);
  }
  return true;
}

bool slides(const MechanismDefinition& definition,
            const InitialJointState& initial) {
  DriveDefinition coordinate;
  coordinate.joint = initial.joint;
  return !drives_angle(definition, coordinate);
}

/// By joints on their bodies and by drives, else by the bodies' centres; where
/// all are nothing beside the bodies, as of a rod that slides through its own
/// middle, one metre: moments over a length of round-off would count for
/// nothing beside forces.
double link_length(const MechanismDefinition& definition,
                   const SolvingFrame& frame) {
  constexpr double kNothing = 0.01, kOne = 1.0;  // [1], [m]
  double least = 0.0;
  for (const BodyDefinition& body : definition.bodies) {
    least =
        std::max(least, kNothing * part::radius_of_mass(body.mass_properties));
  }
  double length = 0.0;
  for (const JointModel& joint : frame.joints) {
    if (joint.a > 0) length = std::max(length, joint.frame_a.p_LJ.norm());
    if (joint.b > 0) length = std::max(length, joint.frame_b.p_LJ.norm());
    length = std::max(length, joint.length);
  }
  for (const DriveDefinition& drive : definition.drives) {
    if (drives_angle(definition, drive)) continue;
    length = std::max({length, std::abs(drive.from), std::abs(drive.to)});
    for (const double x : drive.table.values) {
      length = std::max(length, std::abs(x));
    }
  }
  double farthest = 0.0;
  for (const InitialJointState& initial : definition.initial_joints) {
    if (!initial.position || !slides(definition, initial)) continue;
    farthest = std::max(farthest, std::abs(*initial.position));
  }
  if (length > least) return std::max(length, farthest);
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    length = std::max(
        length,
        (definition.bodies[i].mass_properties.p_LCm - frame.p_LM[i]).norm());
  }
  return std::max(length > least ? length : kOne, farthest);
}

/// Shifts the bodies of a planar mechanism along the normal until the joints
/// meet, from ground outwards; motion in the plane does not change this.
void close_out_of_plane(SolvingFrame& frame) {
  std::vector<bool> seen(frame.placement.size(), false);
  seen[0] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const JointModel& joint : frame.joints) {
      if (traits(joint.type).in_plane == JointTraits::InPlane::kNoAxis)
        continue;
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
    if (!traits(joint.type).counts_turns) continue;
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

/// What strains a link beside its joints as wrenches at these would.
/// @param displacements  at the joints, one column each.
Eigen::MatrixXd root_of(
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>& modes,
    const Eigen::MatrixXd& displacements) {
  constexpr double kRoundOff = 1e-12;
  const double least = kRoundOff * modes.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::VectorXd inverse = modes.eigenvalues().unaryExpr([&](double c) {
    return c > least ? 1.0 / std::sqrt(c) : 0.0;
  });
  return inverse.asDiagonal() * modes.eigenvectors().transpose() *
         displacements;
}

std::vector<ElasticLink> elastic_links(const MechanismDefinition& definition) {
  std::vector<ElasticLink> links;
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    const auto& given = definition.bodies[i].compliance;
    if (!given) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(given->matrix);
    ElasticLink link{
        .slot = static_cast<int>(i) + 1,
        .joints = given->joints,
        .points = given->points,
        .root = modes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                modes.eigenvectors().transpose(),
        .spin_root = {},
        .loads = given->loads,
        .load_root = {}};
    if (given->by_spin.size() > 0) {
      link.spin_root = root_of(modes, given->by_spin);
    }
    if (given->by_load.size() > 0) {
      link.load_root = root_of(modes, given->by_load);
    }
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      const JointDefinition& joint = definition.joints[index(link.joints[k])];
      const bool is_b = joint.body_b == static_cast<int>(i);
      link.points[k] -= (is_b ? joint.frame_b : joint.frame_a).p_LJ;
    }
    links.push_back(std::move(link));
  }
  return links;
}

ToothMesh tooth_mesh(const std::vector<JointDefinition>& joints,
                     const CouplingDefinition& coupling,
                     const CouplingModel& model) {
  const ToothGeometry& teeth = *coupling.teeth;
  const MeshingWheels wheels = *meshing_wheels(joints, coupling);
  const auto side = [&](int joint, BodyIndex wheel) {
    return joints[index(joint)].body_b == wheel ? 1.0 : -1.0;
  };
  const bool is_gear = model.row_1.is_angle();
  return {
      .wheel_1 = wheels.wheel_1 + 1,
      .wheel_2 = wheels.wheel_2 + 1,
      .carrier = wheels.carrier_1 + 1,
      .side_1 = side(coupling.joint_1, wheels.wheel_1),
      .side_2 = side(coupling.joint_2, wheels.wheel_2),
      .row_1 = model.row_1,
      .row_2 = model.row_2,
      .circles = is_gear ? pitch_circles(joints, coupling) : PitchCircles{},
      .radius = is_gear ? 0.0 : coupling.ratio,
      .radial = std::tan(teeth.pressure_angle) / std::cos(teeth.helix_angle),
      .axial = std::tan(teeth.helix_angle),
      .mid_face = teeth.mid_face.value_or(0.0)};
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
  is_tree = forms_tree(*this);
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
    CouplingModel& model =
        couplings.emplace_back(coupling_model(coupling, *this));
    if (coupling.teeth) {
      model.teeth = tooth_mesh(definition.joints, coupling, model);
    }
  }
}

double SolvingFrame::rank_threshold() const {
  constexpr double kOfTrees = 1e-12;
  return is_tree ? kOfTrees : numerics::kRankThreshold;
}

}  // namespace clevis::mechanism
