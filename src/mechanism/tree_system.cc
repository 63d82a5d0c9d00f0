#include "mechanism/tree_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

std::size_t index(Index i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

TreeSystem::TreeSystem(const MechanismDefinition& definition,
                       ForwardDynamics& dynamics, JointCoordinates& coordinates)
    : dynamics_(dynamics),
      coordinates_(coordinates),
      loads_(dynamics.applied()),
      bodies_(definition, coordinates),
      x_(dynamics.configuration()),
      twists_(x_.size()),
      levers_(x_.size()),
      turned_(coordinates.links().size()),
      start_y_(VectorXd::Zero(dynamics.size())),
      start_z_(VectorXd::Zero(size())) {
  sizes_.setZero(internal_index());
  internal_.setZero(dynamics.forces().internal_states());
}

void TreeSystem::place(const VectorXd& z) {
  coordinates_.place(z.data(), z.data() + coordinates_.coordinates(), x_,
                     twists_);
}

void TreeSystem::rate(double t, const VectorXd& z, VectorXd& rate) {
  place(z);
  loads_.evaluate(t, x_, twists_, z.data() + internal_index());
  double* u_rate = rate.data() + coordinates_.coordinates();
  if (!bodies_.factor(x_)) {
    rate.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  bodies_.accelerate(loads_.wrenches(), x_, &twists_, u_rate);
  coordinates_.rates(z.data(), z.data() + coordinates_.coordinates(),
                     rate.data());
  loads_.forces().internal_rates(rate.data() + internal_index());
  rate[work_index()] = loads_.power(twists_);
}

void TreeSystem::hold_tangents(double t, const VectorXd& z) {
  place(z);
  loads_.hold_tangents(t, x_, twists_, z.data() + internal_index());
}

void TreeSystem::effort_response(Index k, Eigen::Ref<VectorXd> rate) {
  const ActingElement& e = loads_.element_of_effort(k);
  std::ranges::fill(levers_, Twist{});
  levers_[index(e.line.a)] = e.levers.a;
  levers_[index(e.line.b)] = e.levers.b;
  rate.setZero();
  bodies_.accelerate(levers_, x_, nullptr,
                     rate.data() + coordinates_.coordinates());
  rate[work_index()] = e.rate;
}

/// Turns of a joint move what hangs on it: so far that it counts as a length.
void TreeSystem::set_scales() {
  const auto& links = coordinates_.links();
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto& motion = coordinates_.motions()[k];
    const Vector3d at = x_[links[k].slot].p;
    double reach = 0.0;
    std::vector<bool> hangs(links.size(), false);
    for (std::size_t m = k; m < links.size(); ++m) {
      hangs[m] = m == k || (links[m].parent >= 0 &&
                            hangs[static_cast<std::size_t>(links[m].parent)]);
      if (hangs[m]) reach = std::max(reach, (x_[links[m].slot].p - at).norm());
    }
    for (int j = 0; j < links[k].count; ++j) {
      const Twist& S = motion.S[static_cast<std::size_t>(j)];
      const bool turns = S.w.squaredNorm() > 0.0;
      const double far = std::max(dynamics_.length(), reach + S.v.norm());
      sizes_[coordinates_.coordinates() + links[k].u + j] =
          turns ? dynamics_.length() / far : dynamics_.length();
    }
    const int first = quaternion_coordinate(links[k].kind);
    for (int j = 0; j < coordinate_count(links[k].kind); ++j) {
      const int velocity = std::min(j, links[k].count - 1);
      sizes_[links[k].q + j] =
          (first >= 0 && j >= first ? 0.5 : 1.0) *
          sizes_[coordinates_.coordinates() + links[k].u + velocity];
    }
  }
}

void TreeSystem::scales(const VectorXd& z, VectorXd& scales) const {
  const Index n = coordinates_.coordinates();
  scales.head(n) = sizes_.head(n);
  scales.segment(n, coordinates_.velocities()) =
      (dynamics_.speed_scale() / dynamics_.length()) *
      sizes_.tail(coordinates_.velocities());
  loads_.forces().internal_scales(z.data() + internal_index(),
                                  scales.data() + internal_index());
  scales[work_index()] = 0.0;
}

void TreeSystem::error_weights(const VectorXd& z, VectorXd& weights) const {
  scales(z, weights);
  weights.head(work_index()) =
      (dynamics_.tolerance() * weights.head(work_index())).cwiseInverse();
}

Index TreeSystem::tangents(double /*t*/, const VectorXd& z,
                           Eigen::MatrixXd& T) {
  T.setZero();
  const Index n = coordinates_.coordinates();
  const double rate = dynamics_.speed_scale() / dynamics_.length();
  Index used = 0;
  for (const auto& link : coordinates_.links()) {
    const int first = quaternion_coordinate(link.kind);
    for (int j = 0; j < link.count; ++j) {
      const double size = sizes_[n + link.u + j];
      if (first >= 0 && j >= first) {
        T.col(used).segment<4>(link.q + first) =
            quaternion_rate(z.segment<4>(link.q + first),
                            0.5 * size * Vector3d::Unit(j - first));
      } else {
        T(link.q + j, used) = size;
      }
      T(n + link.u + j, coordinates_.velocities() + used++) = rate * size;
    }
  }
  used *= 2;
  loads_.forces().internal_scales(z.data() + internal_index(),
                                  internal_.data());
  for (Index i = 0; i < internal_.size(); ++i) {
    if (internal_[i] == 0.0) continue;
    const Index at = internal_index() + i;
    T(at, used++) = std::max(internal_[i], std::abs(z[at]));
  }
  return used;
}

void TreeSystem::start(double t, const VectorXd& y, VectorXd& z) {
  z.setZero();
  read(t, y, z);
  start_y_ = y;
  start_z_ = z;
  place(z);
  set_scales();
}

void TreeSystem::read(double t, const VectorXd& y, VectorXd& z) {
  dynamics_.place(t, y);
  coordinates_.read(dynamics_.configuration(), dynamics_.twists(), z.data(),
                    z.data() + coordinates_.coordinates());
  z.tail(z.size() - internal_index()) =
      y.tail(y.size() - dynamics_.internal_index());
}

void TreeSystem::expand(const VectorXd& z, VectorXd& y) {
  place(z);
  const auto& links = coordinates_.links();
  for (std::size_t k = 0; k < links.size() && dynamics_.is_planar(); ++k) {
    const auto& link = links[k];
    turned_[k] =
        link.parent < 0 ? 0.0 : turned_[static_cast<std::size_t>(link.parent)];
    for (int j = 0; j < link.count; ++j) {
      turned_[k] +=
          coordinates_.motions()[k].S[static_cast<std::size_t>(j)].w.z() *
          (z[link.q + j] - start_z_[link.q + j]);
    }
  }
  for (std::size_t k = 0; k < links.size(); ++k) {
    dynamics_.put_body(links[k].slot, x_[links[k].slot], twists_[links[k].slot],
                       start_y_, turned_[k], y);
  }
  y.tail(y.size() - dynamics_.internal_index()) =
      z.tail(z.size() - internal_index());
}

}  // namespace clevis::mechanism
