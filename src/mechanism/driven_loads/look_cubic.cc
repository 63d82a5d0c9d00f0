#include "mechanism/driven_loads/look_cubic.h"

#include <array>

namespace clevis::mechanism {

using Eigen::VectorXd;

namespace {

/// Weights of the polynomial through some times, at another.
template <std::size_t n>
std::array<double, n> lagrange(const std::array<double, n>& t, double at) {
  std::array<double, n> weights;
  for (std::size_t j = 0; j < n; ++j) {
    weights[j] = 1.0;
    for (std::size_t k = 0; k < n; ++k) {
      if (k != j) weights[j] *= (at - t[k]) / (t[j] - t[k]);
    }
  }
  return weights;
}

}  // namespace

std::optional<VectorXd> by_cubic(const std::vector<DrivenTrajectory::At>& about,
                                 double t) {
  if (about.size() != 4) return std::nullopt;
  const std::array<double, 4> times{about[0]->t, about[1]->t, about[2]->t,
                                    about[3]->t};
  const auto weights = lagrange(times, t);
  VectorXd value = weights[0] * about[0]->loads;
  for (std::size_t k = 1; k < 4; ++k) value += weights[k] * about[k]->loads;
  return value;
}

}  // namespace clevis::mechanism
