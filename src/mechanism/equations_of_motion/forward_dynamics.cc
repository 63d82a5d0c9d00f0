#include "mechanism/equations_of_motion/forward_dynamics.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include "base/index.h"

namespace clevis::mechanism {
namespace {

// Part of a combination of rows above which a row takes part in it.
constexpr double kTakesPart = 1e-6;

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Unknown of the rotor of each force element, or −1.
std::vector<Index> rotor_unknowns(const ForceModel& forces, Index bodies) {
  std::vector<Index> unknowns(forces.size(), -1);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.inertia(k) > 0.0) unknowns[k] = bodies++;
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

/// F with F Fᵀ = inertia⁻¹.
Matrix3d inverse_root(const Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(inertia);
  return eigen.eigenvectors() *
         eigen.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

SolvingFrame frame_at_centres(const MechanismDefinition& definition) {
  SolvingFrame frame(definition);
  std::vector<Vector3d> shift(definition.bodies.size() + 1, Vector3d::Zero());
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    shift[i + 1] = definition.bodies[i].mass_properties.p_LCm - frame.p_LM[i];
    frame.p_LM[i] = definition.bodies[i].mass_properties.p_LCm;
    frame.placement[i + 1].p += frame.placement[i + 1].R * shift[i + 1];
  }
  for (JointModel& joint : frame.joints) {
    joint.frame_a.p_LJ -= shift[index(joint.a)];
    joint.frame_b.p_LJ -= shift[index(joint.b)];
  }
  return frame;
}

ForwardDynamics::ForwardDynamics(const MechanismDefinition& definition,
                                 const SolvingFrame& frame, double tolerance,
                                 double duration)
    : frame_(frame),
      drives_(definition.drives),
      system_(frame, definition.drives,
              frame.planar ? Motions::kInPlane : Motions::kSpatial,
              ConstraintSystem::Drives::kAll),
      applied_(definition, frame),
      forces_(applied_.forces()),
      rotors_(rotor_unknowns(forces_, system_.columns())),
      columns_(all_unknowns(rotors_, system_.columns())),
      mass_(static_cast<int>(columns_),
            system_.rows() + static_cast<int>(forces_.size()),
            frame.rank_threshold()),
      following_(forces_, system_, static_cast<int>(columns_),
                 system_.rows() + static_cast<int>(forces_.size())),
      planar_(frame.planar),
      length_(frame.length),
      tolerance_(tolerance),
      slowest_(frame.length / duration),
      positions_(static_cast<Index>(definition.bodies.size()) *
                 (planar_ ? 3 : 7)),
      bodies_(definition.bodies.size() + 1),
      x_(frame.placement),
      twists_(frame.placement.size()) {
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    const part::MassProperties& given =
        definition.bodies[i - 1].mass_properties;
    Body& body = bodies_[i];
    body.inertia = given.inertia_LCm;
    body.turn_factor = length_ * inverse_root(given.inertia_LCm);
    body.turn_root = body.turn_factor.inverse();
    body.R_start = frame.placement[i].R;
    body.inertia_z =
        (body.R_start * given.inertia_LCm * body.R_start.transpose())(2, 2);
    const double root = 1.0 / std::sqrt(given.mass);
    const int k = static_cast<int>(i) - 1;
    if (planar_) {
      mass_.set_diagonal(k, {root, root, length_ / std::sqrt(body.inertia_z)});
    } else {
      mass_.set_diagonal(2 * k, Vector3d::Constant(root));
    }
  }
  placed_ = system_.place(x_);
  for (const double angle : x_.angles) turns_.push_back({angle, 0.0});
  for (std::size_t k = 0; planar_ && k < forces_.size(); ++k) {
    const ActingElement& e = forces_.element(k);
    if (e.joint < 0 || !forces_.is_angle(k)) continue;
    plane_angles_.push_back({k, static_cast<std::size_t>(e.joint), e.q_start});
  }
  rows_ = system_.rows();
  const Index most = rows_ + static_cast<Index>(forces_.size());
  J_.setZero(most, columns_);
  for (VectorXd* v : {&u_, &Q_, &acceleration_, &change_}) v->setZero(columns_);
  place_rotors();
  for (VectorXd* v :
       {&target_rates_, &target_seconds_, &residual_, &gamma_, &lambda_}) {
    v->setZero(most);
  }
  mass_.set_tree(links(), planar_ ? 3 : 6);
  scratch_.setZero(size());
  response_.setZero(columns_);
  response_rows_.setZero(most);
  targets_.setZero(static_cast<Index>(drives_.size()));
}

std::vector<TreeLink> ForwardDynamics::links() const {
  std::vector<int> joints;
  for (const ConstraintSystem::Row& row : system_.row_list()) {
    joints.push_back(row.joint);
  }
  return tree_links(frame_, joints);
}

/// Mass of the rotors' unknowns.
void ForwardDynamics::place_rotors() {
  VectorXd root = VectorXd::Ones(columns_);
  for (std::size_t k = 0; k < rotors_.size(); ++k) {
    if (rotors_[k] < 0) continue;
    root[rotors_[k]] = row_scale(k) / std::sqrt(forces_.inertia(k));
  }
  for (Index at = system_.columns(); at < columns_; at += 3) {
    mass_.set_diagonal(static_cast<int>(at / 3), root.segment<3>(at));
  }
}

/// @return false where the rows are not those of a tree, or not clearly
///   independent.
bool ForwardDynamics::factor_tree() {
  TreeMass* tree = mass_.tree();
  if (tree == nullptr) return false;
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (forces_.brings_row(k)) return false;
  }
  const auto put = [this](const Twist& lever, double scale, int slot,
                          double* row) {
    for (int c = 0; c < 3; ++c) {
      row[c] = scale * lever.v[c];
      if (!planar_) row[3 + c] = scale / length_ * lever.w[c];
    }
    if (planar_) row[2] = scale / length_ * lever.w.z();
    mass_.apply_factor_of_body(slot - 1, row);
  };
  for (const TreeLink& link : tree->links()) {
    for (const int i : link.rows) {
      const ConstraintSystem::Row& row = system_.row_list()[index(i)];
      const JointModel& joint = frame_.joints[index(row.joint)];
      const PlacedJoint::Levers levers =
          placed_[index(row.joint)].levers(row.row);
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

void ForwardDynamics::factor() {
  if (factor_tree()) return;
  system_.fill_jacobian(placed_, J_);
  rows_ = system_.rows();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.brings_row(k)) continue;
    const ActingElement& e = forces_.element(k);
    J_.row(rows_).setZero();
    system_.add_levers(J_, rows_, e.line.a, e.line.b, e.levers, row_scale(k));
    if (rotors_[k] >= 0) J_(rows_, rotors_[k]) = -1.0;
    ++rows_;
  }
  mass_.factor(J_, rows_);
}

/// Wrenches about the centres of mass, and Q of them.
void ForwardDynamics::add_loads(double t, const VectorXd& y) {
  applied_.evaluate(t, x_, twists_, y.data() + internal_index());
  const std::vector<Twist>& wrenches = applied_.wrenches();
  for (std::size_t i = 1; i < wrenches.size(); ++i) {
    if (planar_) {
      const auto at = static_cast<Index>(3 * (i - 1));
      Q_.segment<2>(at) = wrenches[i].v.head<2>();
      Q_[at + 2] = wrenches[i].w.z() / length_;
    } else {
      const auto at = static_cast<Index>(6 * (i - 1));
      const Matrix3d& R = x_[i].R;
      const Vector3d& w = twists_[i].w;
      const Vector3d spin = R * (bodies_[i].inertia * (R.transpose() * w));
      Q_.segment<3>(at) = wrenches[i].v;
      Q_.segment<3>(at + 3) = (wrenches[i].w - w.cross(spin)) / length_;
    }
  }
}

void ForwardDynamics::evaluate_loads(double t, const VectorXd& y) {
  place(t, y);
  add_loads(t, y);
}

void ForwardDynamics::rate(double t, const VectorXd& y, VectorXd& rate) {
  place(t, y);
  set_targets(t);
  add_loads(t, y);
  factor();
  system_.bias(placed_, twists_, gamma_);
  gamma_.head(system_.rows()) =
      target_seconds_.head(system_.rows()) - gamma_.head(system_.rows());
  Index row = system_.rows();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.brings_row(k)) continue;
    gamma_[row++] = -row_scale(k) * forces_.line_bias(k, twists_);
  }
  mass_.accelerate(gamma_, Q_, acceleration_, lambda_);
  if (mass_.rank() < rows_) share_among_sticking();
  double power = following_.empty()
                     ? 0.0
                     : following_.solve(forces_, mass_, acceleration_, lambda_);
  row = system_.rows();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.brings_row(k)) continue;
    forces_.set_row_effort(k, row_scale(k) * lambda_[row++]);
  }
  forces_.internal_rates(rate.data() + internal_index());
  power += applied_.power(twists_);
  put_position_rates(y, rate);
  rate.segment(positions_, system_.columns()) =
      acceleration_.head(system_.columns());
  for (Index i = system_.joint_rows(); i < system_.rows(); ++i) {
    power += lambda_[i] * target_rates_[i];
  }
  rate[work_index()] = power;
}

void ForwardDynamics::hold_tangents(double t, const VectorXd& y) {
  place(t, y);
  applied_.hold_tangents(t, x_, twists_, y.data() + internal_index());
}

void ForwardDynamics::effort_response(Index k, Eigen::Ref<VectorXd> rate) {
  const ActingElement& e = applied_.element_of_effort(k);
  change_.setZero();
  put_lever(e.line.a, e.levers.a, change_);
  put_lever(e.line.b, e.levers.b, change_);
  respond(change_, response_);
  rate.setZero();
  rate.segment(positions_, system_.columns()) =
      response_.head(system_.columns());
  double power = e.rate;
  for (Index i = system_.joint_rows(); i < system_.rows(); ++i) {
    power += response_rows_[i] * target_rates_[i];
  }
  rate[work_index()] = power;
}

double ForwardDynamics::largest_load() const {
  double largest = 0.0;
  for (const Twist& wrench : applied_.wrenches()) {
    largest = std::max(largest, wrench.v.norm() + wrench.w.norm() / length_);
  }
  return largest;
}

void ForwardDynamics::event_values(double t, const VectorXd& y,
                                   VectorXd& values) {
  rate(t, y, scratch_);
  forces_.event_values(values);
}

void ForwardDynamics::guard_values(double t, const VectorXd& y,
                                   VectorXd& values) {
  if (forces_.any_sticks()) {
    event_values(t, y, values);
    return;
  }
  evaluate_forces(t, y);
  forces_.event_values(values);
}

/// Orthonormal combinations of rows that vanish: what may be added to the
/// multipliers.
MatrixXd ForwardDynamics::open_multipliers() const {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> rows;
  rows.setThreshold(numerics::kRankThreshold);
  rows.compute(J_.topRows(rows_));
  const Index open = rows_ - rows.rank();
  MatrixXd free = MatrixXd::Zero(rows_, open);
  free.bottomRows(open).setIdentity();
  if (open > 0) free.applyOnTheLeft(rows.householderQ());
  return free;
}

void ForwardDynamics::share_among_sticking() {
  Index row = system_.rows(), count = 0;
  VectorXd ratio = VectorXd::Zero(rows_);
  VectorXd weight = VectorXd::Zero(rows_);
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.brings_row(k)) continue;
    const double most = forces_.sticks(k) ? forces_.breakaway(k) : 0.0;
    if (most > 0.0) {
      weight[row] = row_scale(k) / most;
      ++count;
    }
    ++row;
  }
  if (count == 0) return;
  const MatrixXd free = open_multipliers();
  if (free.cols() == 0) return;
  ratio = weight.cwiseProduct(lambda_.head(rows_));
  const MatrixXd shares = weight.asDiagonal() * free;
  // combinations of joints' rows alone, which are redundant, have no part
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> sharing(shares.rows(),
                                                           shares.cols());
  sharing.setThreshold(kTakesPart * weight.maxCoeff() /
                       std::max(shares.norm(), 1e-300));
  sharing.compute(shares);
  lambda_.head(rows_) -= free * sharing.solve(ratio);
}

void ForwardDynamics::evaluate_forces(double t, const Eigen::VectorXd& y) {
  place(t, y);
  forces_.evaluate(t, x_, twists_, y.data() + internal_index());
}

void ForwardDynamics::put_lever(int slot, const Twist& lever,
                                Eigen::VectorXd& force) const {
  if (slot == 0) return;
  if (planar_) {
    const Eigen::Index at = 3 * (slot - 1);
    force.segment<2>(at) += lever.v.head<2>();
    force[at + 2] += lever.w.z() / length_;
  } else {
    const Eigen::Index at = 6 * (slot - 1);
    force.segment<3>(at) += lever.v;
    force.segment<3>(at + 3) += lever.w / length_;
  }
}

double ForwardDynamics::free_response(int slot, const Twist& lever) const {
  if (slot == 0) return 0.0;
  const auto at = static_cast<std::size_t>(slot);
  const Eigen::Vector3d turn =
      bodies_[at].turn_factor.transpose() * x_[at].R.transpose() * lever.w;
  return lever.v.squaredNorm() / applied_.mass(at) +
         turn.squaredNorm() / (length_ * length_);
}

void ForwardDynamics::respond(const VectorXd& force, VectorXd& accelerations) {
  residual_.setZero();
  mass_.accelerate(residual_, force, accelerations, response_rows_);
}

}  // namespace clevis::mechanism
