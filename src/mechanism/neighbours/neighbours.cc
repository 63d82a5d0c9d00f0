#include "mechanism/neighbours/neighbours.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/algebra/singular_vectors.h"
#include "base/values/index.h"
#include "mechanism/mass_matrix/centre_frame.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr std::size_t kMostBodies = 100;
constexpr Index kTwist = 6;

using Elements = std::vector<std::unique_ptr<ActingElement>>;

Elements placed(const MechanismDefinition& definition,
                const SolvingFrame& frame) {
  Elements elements;
  for (const ForceElement& element : definition.elements) {
    elements.push_back(place(element, frame));
  }
  return elements;
}

/// Slots of the bodies that joints, couplings and force elements join to one,
/// the nearest by these first.
std::vector<int> neighbours_of(const SolvingFrame& frame,
                               const Elements& elements, int slot) {
  std::vector<int> found;
  std::vector<bool> is_known(frame.placement.size(), false);
  is_known[0] = is_known[index(slot)] = true;
  std::deque<int> next{slot};
  const auto join = [&](int here, int there) {
    if (here != next.front() || is_known[index(there)]) return;
    is_known[index(there)] = true;
    found.push_back(there);
    next.push_back(there);
  };
  for (; !next.empty() && found.size() < kMostBodies; next.pop_front()) {
    for (const JointModel& joint : frame.joints) {
      join(joint.a, joint.b);
      join(joint.b, joint.a);
    }
    for (const auto& element : elements) {
      join(element->line.a, element->line.b);
      join(element->line.b, element->line.a);
    }
    for (const CouplingModel& coupling : frame.couplings) {
      const JointModel& first = frame.joints[index(coupling.joint_1)];
      const JointModel& second = frame.joints[index(coupling.joint_2)];
      for (const int a : {first.a, first.b}) {
        for (const int b : {second.a, second.b}) {
          join(a, b);
          join(b, a);
        }
      }
    }
  }
  return found;
}

constexpr double kRoundOff = 1e-9;  // of rows of pure numbers

}  // namespace

Configuration configuration_at(const SolvingFrame& frame,
                               const Instant& instant) {
  Configuration x(instant.bodies.size() + 1);
  for (std::size_t i = 0; i < instant.bodies.size(); ++i) {
    const Pose& pose = instant.bodies[i].pose;
    BodyPlacement& at = x[i + 1];
    at.R = frame.R_WP.transpose() * pose.R_WL;
    at.q = Eigen::Quaterniond(at.R);
    at.p = frame.R_WP.transpose() * pose.p_WL + at.R * frame.p_LM[i];
  }
  return x;
}

PlacedJoint::Levers levers_of(const ActingElement& element,
                              const Configuration& x) {
  const JointModel& line = element.line;
  return PlacedJoint{line, x[index(line.a)], x[index(line.b)]}.levers(
      element.row);
}

Eigen::VectorXd row_along(const ActingElement& element, const Configuration& x,
                          const ConstraintSystem& system) {
  const PlacedJoint::Levers levers = levers_of(element, x);
  std::vector<SpatialForce> all(x.size());
  all[index(element.line.a)] = levers.a;
  all[index(element.line.b)] = levers.b;
  return system.wrench_vector(all);
}

MatrixXd root_of(const MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return solver.eigenvectors() *
         solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

Neighbours::Neighbours(const MechanismDefinition& definition, BodyIndex body)
    : definition_(definition),
      frame_(frame_at_centres(definition)),
      system_(frame_, definition.drives, Motions::kSpatial,
              ConstraintSystem::Drives::kAll),
      slot_(body + 1),
      elements_(placed(definition, frame_)),
      slots_(neighbours_of(frame_, elements_, slot_)) {}

/// Teeth hold both wheels along their line of action. A coupling's own row
/// holds turns against the bearings, which bearings that give way take along.
Eigen::VectorXd Neighbours::row_of_teeth(const CouplingModel& coupling,
                                         const Configuration& x,
                                         const std::vector<PlacedJoint>& placed,
                                         double effort) const {
  const ToothMesh& teeth = *coupling.teeth;
  const ToothContact contact =
      tooth_contact(teeth, placed[index(coupling.joint_1)],
                    placed[index(coupling.joint_2)], effort < 0.0 ? -1.0 : 1.0);
  const Vector3d along = contact.force.normalized();
  std::vector<SpatialForce> levers(x.size());
  for (const auto& [wheel, sign] :
       {std::pair{teeth.wheel_1, 1.0}, std::pair{teeth.wheel_2, -1.0}}) {
    const Vector3d arm = contact.point - x[index(wheel)].p;
    levers[index(wheel)] = {.v = sign * along, .w = sign * arm.cross(along)};
  }
  return system_.wrench_vector(levers);
}

NeighbourPlace Neighbours::place_of(const ConstraintSystem::Row& row,
                                    bool is_drive) const {
  const JointModel& first = frame_.joints[index(row.joint)];
  const bool is_second =
      row.coupling >= 0 && first.a != slot_ && first.b != slot_;
  return {is_second ? frame_.couplings[index(row.coupling)].joint_2 : row.joint,
          is_drive};
}

NeighbourRows Neighbours::rows(const Instant& instant) const {
  NeighbourRows found;
  found.x = configuration_at(frame_, instant);
  const std::vector<PlacedJoint> placed = system_.place(found.x);
  MatrixXd J = system_.jacobian(placed);
  for (Index row = 0; row < J.rows(); ++row) {
    const int coupling = system_.row_list()[index(row)].coupling;
    if (coupling < 0 || !frame_.couplings[index(coupling)].teeth) continue;
    J.row(row) = row_of_teeth(frame_.couplings[index(coupling)], found.x,
                              placed, instant.couplings[index(coupling)].effort)
                     .transpose();
  }
  const Index of_constraints = J.rows();
  J.conservativeResize(of_constraints + std::ssize(held_lines_),
                       Eigen::NoChange);
  for (std::size_t k = 0; k < held_lines_.size(); ++k) {
    J.row(of_constraints + static_cast<Index>(k)) =
        row_along(*elements_[held_lines_[k]], found.x, system_).transpose();
  }
  const auto block = [&](Index row, int of) {
    return J.row(row).segment<kTwist>(kTwist * (of - 1));
  };
  std::vector<Index> own, among;
  for (Index row = 0; row < J.rows(); ++row) {
    if (block(row, slot_).isZero(0.0)) {
      if (std::ranges::any_of(slots_, [&](int neighbour) {
            return !block(row, neighbour).isZero(0.0);
          })) {
        among.push_back(row);
      }
      continue;
    }
    const NeighbourPlace place =
        row < of_constraints
            ? place_of(system_.row_list()[index(row)],
                       row >= system_.joint_rows())
            : NeighbourPlace{
                  -1, false,
                  static_cast<int>(held_lines_[index(row - of_constraints)])};
    const auto known = std::ranges::find(found.places, place);
    found.place_of.push_back(index(known - found.places.begin()));
    if (known == found.places.end()) found.places.push_back(place);
    own.push_back(row);
  }
  const auto of_neighbours = [&](const std::vector<Index>& rows) {
    MatrixXd part(std::ssize(rows), kTwist * std::ssize(slots_));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < slots_.size(); ++k) {
        part.row(static_cast<Index>(i))
            .segment<kTwist>(kTwist * static_cast<Index>(k)) =
            block(rows[i], slots_[k]);
      }
    }
    return part;
  };
  found.body.resize(std::ssize(own), kTwist);
  for (std::size_t i = 0; i < own.size(); ++i) {
    found.body.row(static_cast<Index>(i)) = block(own[i], slot_);
  }
  found.there = of_neighbours(own);
  found.free = null_space(of_neighbours(among), kRoundOff);
  return found;
}

MatrixXd Neighbours::masses(const Configuration& x) const {
  const Index size = kTwist * std::ssize(slots_);
  const double square = frame_.length * frame_.length;
  MatrixXd mass = MatrixXd::Zero(size, size);
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    const Index at = kTwist * static_cast<Index>(k);
    const auto& given =
        definition_.bodies[index(slots_[k] - 1)].mass_properties;
    const Matrix3d& R = x[index(slots_[k])].R;
    mass.block<3, 3>(at, at) = given.mass * Matrix3d::Identity();
    mass.block<3, 3>(at + 3, at + 3) =
        R * given.inertia_LCm * R.transpose() / square;
  }
  for (const auto& element : elements_) {
    if (!element || !(element->inertia() > 0.0) || acts_on_body(*element)) {
      continue;
    }
    const PlacedJoint::Levers levers = levers_of(*element, x);
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(size);
    add_action(element->line.a, levers.a, turn);
    add_action(element->line.b, levers.b, turn);
    mass += element->inertia() * turn * turn.transpose();
  }
  return mass;
}

void Neighbours::add_action(int slot, const SpatialForce& action,
                            Eigen::Ref<Eigen::VectorXd> row) const {
  const auto at = std::ranges::find(slots_, slot) - slots_.begin();
  if (at == std::ssize(slots_)) return;
  row.segment<3>(kTwist * at) += action.v;
  row.segment<3>(kTwist * at + 3) += action.w / frame_.length;
}

}  // namespace clevis::mechanism
