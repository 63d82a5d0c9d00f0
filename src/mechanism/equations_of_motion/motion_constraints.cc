#include "mechanism/equations_of_motion/motion_constraints.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "base/values/index.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Unknown of the rotor of each force element, or −1.
std::vector<Index> rotor_unknowns(const ForceModel& forces, Index bodies) {
  std::vector<Index> unknowns(forces.size(), -1);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).inertia() > 0.0) unknowns[k] = bodies++;
  }
  return unknowns;
}

/// Unknowns of bodies and rotors, a multiple of 3.
Index all_unknowns(const std::vector<Index>& rotors, Index bodies) {
  const auto count = std::ranges::count_if(rotors, [](Index r) {
    return r >= 0;
  });
  return bodies + (count + 2) / 3 * 3;
}

}  // namespace

MotionConstraints::MotionConstraints(const SolvingFrame& frame,
                                     const ConstraintSystem& system,
                                     const ForceModel& forces,
                                     const BodyInertias& inertias)
    : frame_(frame),
      system_(system),
      forces_(forces),
      rotors_(rotor_unknowns(forces, system.columns())),
      columns_(all_unknowns(rotors_, system.columns())),
      mass_(static_cast<int>(columns_),
            system.rows() + static_cast<int>(forces.size()),
            frame.rank_threshold()),
      rows_(system.rows()) {
  J_.setZero(rows_ + static_cast<Index>(forces.size()), columns_);
  inertias.put_constant_blocks(mass_);
  put_rotors();
  mass_.set_tree(links(), frame.planar ? 3 : 6);
}

std::vector<TreeLink> MotionConstraints::links() const {
  std::vector<int> joints;
  for (const ConstraintSystem::Row& row : system_.row_list()) {
    joints.push_back(row.joint);
  }
  return tree_links(frame_, joints);
}

/// Mass of the rotors' unknowns.
void MotionConstraints::put_rotors() {
  VectorXd root = VectorXd::Ones(columns_);
  for (std::size_t k = 0; k < rotors_.size(); ++k) {
    if (!turns_rotor(k)) continue;
    root[rotors_[k]] = row_scale(k) / std::sqrt(forces_.element(k).inertia());
  }
  for (Index at = system_.columns(); at < columns_; at += 3) {
    mass_.set_diagonal(static_cast<int>(at / 3), root.segment<3>(at));
  }
}

/// @return false where the rows are not those of a tree, or not clearly
///   independent.
bool MotionConstraints::factor_tree(const std::vector<PlacedJoint>& placed) {
  TreeMass* tree = mass_.tree();
  if (tree == nullptr) return false;
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (brings_row(forces_.element(k))) return false;
  }
  const bool planar = frame_.planar;
  const double length = frame_.length;
  const auto put = [&](const SpatialForce& lever, double scale, int slot,
                       double* row) {
    for (int c = 0; c < 3; ++c) {
      row[c] = scale * lever.v[c];
      if (!planar) row[3 + c] = scale / length * lever.w[c];
    }
    if (planar) row[2] = scale / length * lever.w.z();
    mass_.apply_factor_of_body(slot - 1, row);
  };
  for (const TreeLink& link : tree->links()) {
    for (const int i : link.rows) {
      const ConstraintSystem::Row& row = system_.row_list()[index(i)];
      const JointModel& joint = frame_.joints[index(row.joint)];
      const PlacedJoint::Levers levers =
          placed[index(row.joint)].levers(row.row);
      const bool b_hangs = joint.b == link.body + 1;
      const double scale = system_.scale(row);
      put(b_hangs ? levers.b : levers.a, scale, link.body + 1,
          tree->of_body(i));
      if (link.parent < 0) continue;
      put(b_hangs ? levers.a : levers.b, scale, link.parent + 1,
          tree->of_parent(i));
    }
  }
  rows_ = system_.rows();
  return mass_.factor_tree();
}

void MotionConstraints::factor(const MechanismState& state) {
  if (factor_tree(state.placed)) return;
  system_.fill_jacobian(state.placed, J_);
  rows_ = system_.rows();
  for_each_element_row([&](std::size_t k, int row) {
    const JointModel& line = forces_.element(k).line;
    J_.row(row).setZero();
    system_.add_levers(J_, row, line.a, line.b,
                       state.loads.forces.elements[k].levers, row_scale(k));
    if (turns_rotor(k)) J_(row, rotors_[k]) = -1.0;
    rows_ = row + 1;
  });
  mass_.factor(J_, rows_);
}

MatrixXd MotionConstraints::open_multipliers() const {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> rows;
  rows.setThreshold(numerics::kRankThreshold);
  rows.compute(J_.topRows(rows_));
  const Index open = rows_ - rows.rank();
  MatrixXd free = MatrixXd::Zero(rows_, open);
  free.bottomRows(open).setIdentity();
  if (open > 0) free.applyOnTheLeft(rows.householderQ());
  return free;
}

}  // namespace clevis::mechanism
