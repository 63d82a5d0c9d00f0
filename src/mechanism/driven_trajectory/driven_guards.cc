#include "mechanism/driven_trajectory/driven_guards.h"

#include "base/values/index.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;
using Kind = ElementGuard::Kind;

DrivenGuards::DrivenGuards(const ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    for (const ElementGuard& guard : forces.element(k).guards()) {
      all_.push_back({k, guard});
    }
  }
}

VectorXd DrivenGuards::values(const ForceModel& forces,
                              const ForceState& acting, double t) const {
  VectorXd values(size());
  for (Index i = 0; i < size(); ++i) {
    const Guard& guard = all_[static_cast<std::size_t>(i)];
    values[i] = forces.element(guard.element)
                    .guard_value(guard.of, t, acting.elements[guard.element]);
  }
  return values;
}

std::vector<std::optional<double>> DrivenGuards::rates(
    const ForceState& acting) const {
  std::vector<std::optional<double>> rates(all_.size());
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const Guard& guard = all_[i];
    const ElementResponse& e = acting.elements[guard.element];
    if (guard.of.kind == Kind::kDepth) {
      rates[i] = e.depth_rate[index(guard.of.end)];
    }
    if (guard.of.kind == Kind::kPosition) rates[i] = e.rate;
  }
  return rates;
}

bool DrivenGuards::matters(Index i, const ForceModel& forces,
                           const ForceState& acting) const {
  const Guard& guard = all_[static_cast<std::size_t>(i)];
  return forces.element(guard.element)
      .guard_matters(guard.of, acting.elements[guard.element]);
}

bool DrivenGuards::jumps(Index i) const {
  return all_[static_cast<std::size_t>(i)].of.kind != Kind::kPosition;
}

}  // namespace clevis::mechanism
