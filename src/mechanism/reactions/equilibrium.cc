#include "mechanism/reactions/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/values/index.h"
#include "mechanism/compliance/compliance_maps.h"
#include "mechanism/compliance/compliant_balance.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Largest force, and moment over length, in the given components.
double largest(const std::vector<SpatialForce>& wrenches, Motions motions,
               double length) {
  double result = 0.0;
  for (const SpatialForce& wrench : wrenches) {
    for (const int k : twist_components(motions)) {
      result = std::max(result, k < 3 ? std::abs(wrench.v[k])
                                      : std::abs(wrench.w[k - 3]) / length);
    }
  }
  return result;
}

/// Force and moment about its point of each load of a link, in its L.
VectorXd loads_on(const ElasticLink& link, const Matrix3d& R_LW,
                  const Vector3d& p_WLo,
                  std::span<const ElementState> elements) {
  VectorXd loads =
      VectorXd::Zero(6 * static_cast<Eigen::Index>(link.loads.size()));
  if (elements.empty()) return loads;
  for (std::size_t k = 0; k < link.loads.size(); ++k) {
    auto load = loads.segment<6>(6 * static_cast<Eigen::Index>(k));
    for (const auto& action : elements[index(link.loads[k].element)].actions) {
      if (action.body != link.slot - 1) continue;
      const Vector3d force = R_LW * action.f_W;
      const Vector3d arm = R_LW * (action.p_W - p_WLo) - link.loads[k].point;
      load.head<3>() += force;
      load.tail<3>() += R_LW * action.t_W + arm.cross(force);
    }
  }
  return loads;
}

}  // namespace

Equilibrium::Equilibrium(const MechanismDefinition& definition,
                         const SolvingFrame& frame,
                         const ConstraintSystem& system)
    : frame_(frame),
      system_(system),
      out_of_plane_(frame, {}, Motions::kOutOfPlane,
                    ConstraintSystem::Drives::kNone),
      in_space_(frame, definition.drives, Motions::kSpatial,
                ConstraintSystem::Drives::kAll),
      inertia_(definition.bodies.size() + 1),
      gravity_(frame.R_WP.transpose() * definition.gravity_W) {
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    const part::MassProperties& given = definition.bodies[i].mass_properties;
    inertia_[i + 1] = {given.mass, given.p_LCm - frame.p_LM[i],
                       given.inertia_LCm};
  }
}

std::vector<Twist> Equilibrium::required_wrenches(
    const Configuration& x, const std::vector<Twist>& twists,
    const std::vector<SpatialAcceleration>& accelerations,
    std::span<const SpatialForce> applied) const {
  std::vector<SpatialForce> required(x.size());
  for (std::size_t i = 1; i < x.size(); ++i) {
    const Inertia& body = inertia_[i];
    const Vector3d c = x[i].R * body.p_MCm;
    const Vector3d& w = twists[i].w;
    const Vector3d& alpha = accelerations[i].w;
    const Vector3d a_cm =
        accelerations[i].v + alpha.cross(c) + w.cross(w.cross(c));
    const Matrix3d inertia = x[i].R * body.about_cm * x[i].R.transpose();
    required[i].v = body.mass * (a_cm - gravity_);
    required[i].w = c.cross(required[i].v) + inertia * alpha +
                    w.cross(Vector3d(inertia * w));
  }
  for (std::size_t i = 1; i < applied.size(); ++i) {
    required[i].v -= applied[i].v;
    required[i].w -= applied[i].w;
  }
  return required;
}

void Equilibrium::add(Solution& solution,
                      const std::vector<PlacedJoint>& placed,
                      const ConstraintSystem& rows,
                      const VectorXd& lambda) const {
  for (int i = 0; i < rows.joint_rows(); ++i) {
    const auto& row = rows.row_list()[index(i)];
    const double value = rows.multiplier(row, lambda[i]);
    if (row.coupling >= 0) {
      const CouplingModel& coupling = frame_.couplings[index(row.coupling)];
      const SpatialForce first =
          placed[index(coupling.joint_1)].action(row.row);
      const SpatialForce second =
          placed[index(coupling.joint_2)].action(coupling.row_2);
      const double value_2 = -coupling.ratio * value;
      solution.couplings[index(row.coupling)] = {.effort = value,
                                                 .f_1_W = value * first.v,
                                                 .t_1_W = value * first.w,
                                                 .f_2_W = value_2 * second.v,
                                                 .t_2_W = value_2 * second.w};
      continue;
    }
    JointReaction& reaction = solution.joints[index(row.joint)];
    const SpatialForce action = placed[index(row.joint)].action(row.row);
    reaction.f_W += value * action.v;
    reaction.t_W += value * action.w;
  }
}

void Equilibrium::mark(Solution& solution, const SharedReactions& shared) {
  for (std::size_t i = 0; i < shared.unique.size(); ++i) {
    if (shared.unique[i]) continue;
    const std::size_t j = i / 6;
    if (j >= solution.joints.size()) {
      solution.couplings[i - 6 * solution.joints.size()].unique = false;
      continue;
    }
    JointReaction& reaction = solution.joints[j];
    reaction.unique = reaction.unique_components[i % 6] = false;
    reaction.spread[i % 6] += shared.spread[static_cast<Eigen::Index>(i)];
  }
}

bool Equilibrium::acts_across_plane(
    const std::vector<PlacedJoint>& placed,
    const std::vector<SpatialForce>& required) const {
  constexpr double kRoundOff = 1e-12;
  const double beside = kRoundOff * frame_.length;
  for (std::size_t j = 0; j < placed.size(); ++j) {
    const JointModel& joint = frame_.joints[j];
    if (joint.a > 0 && std::abs(placed[j].r_a.z()) > beside) return true;
    if (joint.b > 0 && std::abs(placed[j].r_b.z()) > beside) return true;
  }
  return largest(required, Motions::kOutOfPlane, frame_.length) >
         kRoundOff * largest(required, Motions::kInPlane, frame_.length);
}

void Equilibrium::solve_out_of_plane(
    Solution& solution, const std::vector<PlacedJoint>& placed,
    std::vector<SpatialForce> required,
    const std::vector<VectorXd>& strains) const {
  // what the reactions and drives in the plane already do across it
  std::vector<Vector3d> forces(placed.size());
  for (std::size_t j = 0; j < placed.size(); ++j) {
    forces[j] = solution.joints[j].f_W;
  }
  for (std::size_t i = 0; i < solution.efforts.size(); ++i) {
    const auto& row = system_.row_list()[index(system_.joint_rows()) + i];
    forces[index(row.joint)] +=
        solution.efforts[i] * placed[index(row.joint)].action(row.row).v;
  }
  for (std::size_t k = 0; k < solution.couplings.size(); ++k) {
    forces[index(frame_.couplings[k].joint_1)] += solution.couplings[k].f_1_W;
    forces[index(frame_.couplings[k].joint_2)] += solution.couplings[k].f_2_W;
  }
  for (std::size_t j = 0; j < placed.size(); ++j) {
    const Vector3d& f = forces[j];
    const Vector3d& t = solution.joints[j].t_W;
    SpatialForce& on_a = required[index(frame_.joints[j].a)];
    SpatialForce& on_b = required[index(frame_.joints[j].b)];
    on_b.v -= f;
    on_b.w -= t + placed[j].r_b.cross(f);
    on_a.v += f;
    on_a.w += t + (placed[j].r_a + placed[j].d).cross(f);
  }
  required[0] = Twist{};
  const MatrixXd J = out_of_plane_.jacobian(placed);
  numerics::JacobianFactor factor;
  factor.compute(J, nullptr, frame_.rank_threshold());
  const SharedReactions shared =
      share_reactions(frame_, out_of_plane_, placed, factor,
                      out_of_plane_.wrench_vector(required), strains);
  add(solution, placed, out_of_plane_, shared.lambda);
  mark(solution, shared);
}

std::optional<Equilibrium::Solution> Equilibrium::solve_in_space(
    const std::vector<PlacedJoint>& placed,
    const std::vector<SpatialForce>& required,
    const std::vector<VectorXd>& strains) const {
  constexpr double kInBalance = 1e-9;
  const VectorXd f = in_space_.wrench_vector(required);
  const MatrixXd J = in_space_.jacobian(placed);
  numerics::JacobianFactor factor;
  factor.compute(J, nullptr, frame_.rank_threshold());
  const SharedReactions shared =
      share_reactions(frame_, in_space_, placed, factor, f, strains);
  const VectorXd left = J.transpose() * shared.lambda - f;
  if (left.norm() > kInBalance * f.norm()) return std::nullopt;
  Solution solution = empty_solution(placed);
  add(solution, placed, in_space_, shared.lambda);
  add_efforts(solution, in_space_, shared.lambda);
  mark(solution, shared);
  return solution;
}

Equilibrium::Solution Equilibrium::empty_solution(
    const std::vector<PlacedJoint>& placed) const {
  Solution solution;
  solution.joints.resize(placed.size());
  solution.couplings.resize(frame_.couplings.size());
  for (std::size_t j = 0; j < placed.size(); ++j) {
    solution.joints[j].p_WJ = placed[j].p_b;
    solution.joints[j].R_WJ = placed[j].axes_a;
  }
  return solution;
}

void Equilibrium::add_efforts(Solution& solution, const ConstraintSystem& rows,
                              const VectorXd& lambda) const {
  for (int i = rows.joint_rows(); i < rows.rows(); ++i) {
    const auto& row = rows.row_list()[index(i)];
    solution.efforts.push_back(rows.multiplier(row, lambda[i]));
  }
}

std::vector<VectorXd> Equilibrium::link_strains(
    const Configuration& x, const std::vector<Twist>& twists,
    std::span<const ElementState> elements) const {
  std::vector<VectorXd> strains;
  for (const ElasticLink& link : frame_.links) {
    const BodyPlacement& body = x[index(link.slot)];
    const Matrix3d R_LW = (frame_.R_WP * body.R).transpose();
    const Vector3d p_WLo =
        frame_.R_WP * (body.p - body.R * frame_.p_LM[index(link.slot - 1)]);
    strains.push_back(strain_beside_joints(
        link, body.R.transpose() * twists[index(link.slot)].w,
        loads_on(link, R_LW, p_WLo, elements)));
  }
  return strains;
}

bool Equilibrium::resolve_teeth(const Configuration& x,
                                const std::vector<PlacedJoint>& placed,
                                std::vector<CouplingState>& couplings,
                                std::vector<SpatialForce>& required) const {
  bool any = false;
  for (std::size_t k = 0; k < couplings.size(); ++k) {
    const CouplingModel& model = frame_.couplings[k];
    CouplingState& coupling = couplings[k];
    if (!model.teeth || !coupling.unique) continue;
    const PlacedJoint& first = placed[index(model.joint_1)];
    const PlacedJoint& second = placed[index(model.joint_2)];
    const ToothContact contact =
        tooth_contact(*model.teeth, first, second, coupling.effort);
    const auto press = [&](int wheel, const Vector3d& force) {
      SpatialForce& wrench = required[index(wheel)];
      wrench.v -= force;
      wrench.w -= (contact.point - x[index(wheel)].p).cross(force);
    };
    press(model.teeth->wheel_1, contact.force);
    press(model.teeth->wheel_2, -contact.force);
    const auto relieve = [&](int joint, const JointRow& row, double effort) {
      const auto levers = placed[index(joint)].levers(row);
      const JointModel& bodies = frame_.joints[index(joint)];
      for (const auto& [slot, lever] :
           {std::pair{bodies.a, levers.a}, std::pair{bodies.b, levers.b}}) {
        required[index(slot)].v += effort * lever.v;
        required[index(slot)].w += effort * lever.w;
      }
    };
    relieve(model.joint_1, model.row_1, coupling.effort);
    relieve(model.joint_2, model.row_2, -model.ratio * coupling.effort);
    coupling.teeth = ToothForce{.f_W = contact.force, .p_W = contact.point};
    any = true;
  }
  required[0] = Twist{};
  return any;
}

Equilibrium::Solution Equilibrium::solve(
    const Configuration& x, const std::vector<PlacedJoint>& placed,
    const numerics::JacobianFactor& factor, const std::vector<Twist>& twists,
    const std::vector<SpatialAcceleration>& accelerations,
    std::span<const SpatialForce> applied,
    std::span<const ElementState> elements) const {
  std::vector<SpatialForce> required =
      required_wrenches(x, twists, accelerations, applied);
  const std::vector<VectorXd> strains = link_strains(x, twists, elements);
  Solution without = reactions(placed, factor, required, strains);
  if (!resolve_teeth(x, placed, without.couplings, required)) return without;
  Solution solution = reactions(placed, factor, required, strains);
  solution.couplings = std::move(without.couplings);
  return solution;
}

Equilibrium::Solution Equilibrium::reactions(
    const std::vector<PlacedJoint>& placed,
    const numerics::JacobianFactor& factor,
    const std::vector<SpatialForce>& required,
    const std::vector<VectorXd>& strains) const {
  const bool across = frame_.planar && acts_across_plane(placed, required);
  const bool open = system_.rows() > factor.rank();
  if (across && open) {
    if (auto solution = solve_in_space(placed, required, strains)) {
      return *solution;
    }
  }
  const VectorXd f = system_.wrench_vector(required);
  SharedReactions shared;
  if (open) {
    shared = share_reactions(frame_, system_, placed, factor, f, strains);
  } else {
    shared.lambda = factor.solve_transposed(f);
  }
  if (!factor.is_regular()) {
    balance_nearly_dependent(placed, f, strains, shared);
  }
  Solution solution = empty_solution(placed);
  add(solution, placed, system_, shared.lambda);
  add_efforts(solution, system_, shared.lambda);
  mark(solution, shared);
  if (across) {
    solve_out_of_plane(solution, placed, required, strains);
  }
  return solution;
}

/// Rows that are nearly dependent count after all where the loads cannot be
/// held without them, as long as that takes no boundless reactions.
void Equilibrium::balance_nearly_dependent(
    const std::vector<PlacedJoint>& placed, const VectorXd& f,
    const std::vector<VectorXd>& strains, SharedReactions& shared) const {
  constexpr double kInBalance = 1e-7, kBoundless = 1e7;
  constexpr double kRoundOff = 1e-12;
  const MatrixXd J = system_.jacobian(placed);
  const auto left = [&](const VectorXd& lambda) {
    return VectorXd(J.transpose() * lambda - f).norm();
  };
  if (left(shared.lambda) <= kInBalance * f.norm()) return;
  numerics::JacobianFactor factor;
  factor.compute(J, nullptr, kRoundOff);
  SharedReactions balanced =
      share_reactions(frame_, system_, placed, factor, f, strains);
  if (left(balanced.lambda) <= kInBalance * f.norm() &&
      balanced.lambda.norm() <= kBoundless * f.norm()) {
    shared = std::move(balanced);
  }
}

std::optional<Equilibrium::Solution> Equilibrium::solve_compliant(
    const Configuration& x, const std::vector<PlacedJoint>& placed,
    const std::vector<Twist>& twists,
    const std::vector<SpatialAcceleration>& accelerations,
    std::span<const SpatialForce> applied, const MatrixXd& held) const {
  std::vector<SpatialForce> required =
      required_wrenches(x, twists, accelerations, applied);
  const auto balanced = [&]() -> std::optional<Solution> {
    const CompliantBalance balance = compliant_balance(
        frame_, system_, x, system_.wrench_vector(required), held);
    if (!balance.found) return std::nullopt;
    Solution solution = empty_solution(placed);
    add(solution, placed, system_, balance.lambda);
    add_efforts(solution, system_, balance.lambda);
    return solution;
  };
  std::optional<Solution> without = balanced();
  if (!without || !resolve_teeth(x, placed, without->couplings, required)) {
    return without;
  }
  std::optional<Solution> solution = balanced();
  if (solution) solution->couplings = std::move(without->couplings);
  return solution;
}

}  // namespace clevis::mechanism
