#include "mechanism/joint_space/tree_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/values/index.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Inertia by velocity of rotors that turn or slide with a joint.
std::vector<double> armatures(const JointCoordinates& coordinates,
                              const ForceModel& forces) {
  std::vector<double> result(index(coordinates.velocities()), 0.0);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const ActingElement& e = forces.element(k);
    if (!(e.inertia() > 0.0)) continue;
    const auto at = coordinates.measured(e.joint, e.row);
    result[index(at->u)] += e.inertia();
  }
  return result;
}

}  // namespace

TreeSystem::TreeSystem(const MechanismDefinition& definition,
                       ForwardDynamics& dynamics, JointCoordinates& coordinates)
    : equations_(dynamics.equations()),
      scales_(dynamics.state_scales()),
      coordinates_(coordinates),
      loads_(equations_.loads()),
      acting_(loads_.none()),
      bodies_(definition, coordinates,
              armatures(coordinates, equations_.forces())),
      x_(equations_.state().x),
      twists_(x_.size()),
      levers_(x_.size()),
      turned_(coordinates.links().size()),
      start_y_(VectorXd::Zero(dynamics.size())),
      internal_(VectorXd::Zero(equations_.forces().internal_states())) {
  for (std::vector<double>* q : {&q_, &q_rate_, &q_start_}) {
    q->resize(index(coordinates.coordinates()));
  }
  for (std::vector<double>* u : {&u_, &u_rate_, &response_}) {
    u->resize(index(coordinates.velocities()));
  }
  for (std::size_t k = 0; k < definition.elements.size(); ++k) {
    const ActingElement& e = equations_.forces().element(k);
    if (e.joint < 0 || !e.row.is_angle()) continue;
    const auto at = coordinates.measured(e.joint, e.row);
    if (at) counted_.push_back({k, *at, 0.0});
  }
}

bool TreeSystem::can_follow(const JointCoordinates& coordinates,
                            const ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const ActingElement& e = forces.element(k);
    if (!(e.inertia() > 0.0)) continue;
    if (e.joint < 0 || !coordinates.measured(e.joint, e.row)) {
      return false;
    }
  }
  return true;
}

void TreeSystem::place(double t, const VectorXd& z) {
  Index at = 0;
  for (const Index i : coordinates_.open_coordinates()) q_[index(i)] = z[at++];
  for (const Index i : coordinates_.open_velocities()) u_[index(i)] = z[at++];
  for (const JointCoordinates::Driven& driven : coordinates_.driven()) {
    const DriveTarget target = equations_.drives().target(driven.drive, t);
    q_[index(driven.q)] = target.position;
    u_[index(driven.u)] = target.rate;
    u_rate_[index(driven.u)] = target.acceleration;
  }
  coordinates_.place(q_.data(), u_.data(), u_rate_.data(), x_, twists_);
  for (const Counted& counted : counted_) {
    const auto& [q, u, sign] = counted.at;
    loads_.forces().element(counted.element).anchor = {
        sign * q_[index(q)] + counted.offset, sign * u_[index(u)], t};
  }
}

/// Of values by coordinate and by velocity.
void TreeSystem::put_open(const std::vector<double>& q,
                          const std::vector<double>& u,
                          Eigen::Ref<VectorXd> z) const {
  Index at = 0;
  for (const Index i : coordinates_.open_coordinates()) z[at++] = q[index(i)];
  for (const Index i : coordinates_.open_velocities()) z[at++] = u[index(i)];
}

/// Likewise.
void TreeSystem::put_driven(const std::vector<double>& q,
                            const std::vector<double>& u,
                            Eigen::Ref<VectorXd> z) const {
  Index at = driven_index();
  for (const JointCoordinates::Driven& driven : coordinates_.driven()) {
    z[at] = q[index(driven.q)];
    z[at++ + this->driven()] = u[index(driven.u)];
  }
}

void TreeSystem::rate(double t, const VectorXd& z, VectorXd& rate) {
  place(t, z);
  loads_.evaluate(t, x_, twists_, z.data() + internal_index(), acting_);
  if (!bodies_.factor(x_)) {
    rate.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  bodies_.accelerate(acting_.wrenches, x_, &twists_, u_rate_.data());
  coordinates_.rates(q_.data(), u_.data(), q_rate_.data());
  put_open(q_rate_, u_rate_, rate);
  put_driven(q_rate_, u_rate_, rate);
  put_internal_rates(acting_.forces, rate.data() + internal_index());
  rate[work_index()] =
      acting_.power(twists_) + bodies_.drive_power(u_.data(), u_rate_.data());
}

void TreeSystem::hold_tangents(double t, const VectorXd& z) {
  place(t, z);
  loads_.hold_tangents(t, x_, twists_, z.data() + internal_index(), acting_);
}

void TreeSystem::effort_response(Index k, Eigen::Ref<VectorXd> rate) {
  const std::size_t which = loads_.element_of_effort(k);
  const JointModel& line = loads_.forces().element(which).line;
  const ElementResponse& e = acting_.forces.elements[which];
  std::ranges::fill(levers_, Twist{});
  levers_[index(line.a)] = e.levers.a;
  levers_[index(line.b)] = e.levers.b;
  rate.setZero();
  bodies_.accelerate(levers_, x_, nullptr, response_.data());
  std::ranges::fill(q_rate_, 0.0);
  put_open(q_rate_, response_, rate);
  rate[work_index()] =
      e.rate + bodies_.drive_power(u_.data(), response_.data());
}

void TreeSystem::start(double t, const VectorXd& y, VectorXd& z) {
  read(t, y, z);
  start_y_ = y;
  q_start_ = q_;
  loads_.evaluate(t, equations_.state().x, equations_.state().twists,
                  z.data() + internal_index(), acting_);
  count_turns();
  place(t, z);
  sizes_ = tree_scales(coordinates_, x_, equations_.layout().length());
}

/// Elements say how many turns they are apart from their coordinates.
void TreeSystem::count_turns() {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (Counted& counted : counted_) {
    const double q = counted.at.sign * q_[index(counted.at.q)];
    const double turns =
        (acting_.forces.elements[counted.element].q - q) / kTurn;
    counted.offset = kTurn * std::round(turns);
  }
}

void TreeSystem::read(double t, const VectorXd& y, VectorXd& z) {
  equations_.place(t, y);
  coordinates_.read(equations_.state().x, equations_.state().twists, q_.data(),
                    u_.data());
  put_open(q_, u_, z);
  put_driven(q_, u_, z);
  z.segment(internal_index(), driven_index() - internal_index()) =
      y.tail(y.size() - equations_.layout().internal_index());
}

void TreeSystem::expand(double t, const VectorXd& z, VectorXd& y) {
  place(t, z);
  const auto& links = coordinates_.links();
  for (std::size_t k = 0; k < links.size() && equations_.layout().is_planar();
       ++k) {
    const auto& link = links[k];
    turned_[k] = link.parent < 0 ? 0.0 : turned_[index(link.parent)];
    for (int j = 0; j < link.count; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const auto q = index(link.q + link.order[at]);
      turned_[k] +=
          coordinates_.motions()[k].S[at].w.z() * (q_[q] - q_start_[q]);
    }
  }
  for (std::size_t k = 0; k < links.size(); ++k) {
    const std::size_t slot = links[k].slot;
    equations_.layout().put_body(slot, x_[slot], twists_[slot], start_y_,
                                 turned_[k], y);
  }
  y.tail(y.size() - equations_.layout().internal_index()) =
      z.segment(internal_index(), driven_index() - internal_index());
  if (!equations_.layout().is_planar()) equations_.turns().anchor(t, x_);
}

void TreeSystem::scales(const VectorXd& z, VectorXd& scales) const {
  put_open(sizes_.q, sizes_.u, scales);
  scales.segment(velocity_index(), open_velocities()) *=
      scales_.speed_scale() / equations_.layout().length();
  loads_.forces().internal_scales(z.data() + internal_index(),
                                  scales.data() + internal_index());
  scales.tail(size() - work_index()).setZero();
}

void TreeSystem::error_weights(const VectorXd& z, VectorXd& weights) const {
  scales(z, weights);
  put_driven(sizes_.q, sizes_.u, weights);
  weights.tail(driven()) *=
      scales_.speed_scale() / equations_.layout().length();
  const auto to_inverse = [&](Eigen::Ref<VectorXd> sizes) {
    sizes = (scales_.tolerance() * sizes).cwiseInverse();
  };
  to_inverse(weights.head(work_index()));
  to_inverse(weights.tail(2 * driven()));
}

Index TreeSystem::tangents(double t, const VectorXd& z, Eigen::MatrixXd& T) {
  place(t, z);
  T.setZero();
  const double rate = scales_.speed_scale() / equations_.layout().length();
  const Index n = open_velocities();
  for (Index i = 0; i < n; ++i) {
    const auto u = index(coordinates_.open_velocities()[index(i)]);
    std::ranges::fill(response_, 0.0);
    response_[u] = sizes_.u[u];
    coordinates_.rates(q_.data(), response_.data(), q_rate_.data());
    Index at = 0;
    for (const Index q : coordinates_.open_coordinates()) {
      T(at++, i) = q_rate_[index(q)];
    }
    T(velocity_index() + i, n + i) = rate * sizes_.u[u];
  }
  Index used = 2 * n;
  loads_.forces().internal_scales(z.data() + internal_index(),
                                  internal_.data());
  for (Index i = 0; i < internal_.size(); ++i) {
    if (internal_[i] == 0.0) continue;
    const Index at = internal_index() + i;
    T(at, used++) = std::max(internal_[i], std::abs(z[at]));
  }
  std::ranges::fill(response_, 0.0);  // driven ones stay so
  return used;
}

}  // namespace clevis::mechanism
