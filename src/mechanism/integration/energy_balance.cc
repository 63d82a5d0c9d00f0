#include "mechanism/integration/energy_balance.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

namespace {

/// Of a body, joints left out, moments over the length [N].
double largest_load(const EquationsOfMotion& equations) {
  const double length = equations.layout().length();
  double largest = 0.0;
  for (const SpatialForce& wrench : equations.state().loads.wrenches) {
    largest = std::max(largest, wrench.v.norm() + wrench.w.norm() / length);
  }
  return largest;
}

}  // namespace

void EnergyBalance::start(const VectorXd& y) {
  start_ = model_.equations.kinetic_energy(y);
}

EnergyBalance::Energies EnergyBalance::energies(const VectorXd& y) const {
  const double kinetic = model_.equations.kinetic_energy(y);
  const double work = y[model_.equations.layout().work_index()];
  return {kinetic, work, std::abs(kinetic - start_ - work)};
}

/// @return what the energies of y differ by [J].
double EnergyBalance::record(const VectorXd& y) {
  const Energies now = energies(y);
  error_ = std::max(error_, now.gap);
  largest_energy_ =
      std::max({largest_energy_, now.kinetic, std::abs(now.work)});
  largest_load_ = std::max(largest_load_, largest_load(model_.equations));
  return now.gap;
}

void EnergyBalance::note_step(const VectorXd& y) {
  step_error_ = std::max(step_error_, record(y));
}

bool EnergyBalance::misses(const VectorXd& y) const {
  const Energies now = energies(y);
  const double largest =
      std::max({largest_energy_, now.kinetic, std::abs(now.work)});
  return now.gap > step_error_ + model_.settings.tolerance * largest;
}

void EnergyBalance::require() const {
  constexpr double kPart = 0.01, kTimesAllowed = 100.0;
  const double tolerance = model_.settings.tolerance;
  const double allowed =
      std::max(kPart, kTimesAllowed * tolerance) * largest_energy_ +
      kTimesAllowed * tolerance * model_.frame.length * largest_load_;
  if (error_ <= allowed) return;
  throw Error("K012", "mechanism",
              fmt::format("kinetic energy and the work of all forces differ by "
                          "{:.3g} J, {:.2g} of the largest: the integration "
                          "failed",
                          error_, error_ / largest_energy_),
              "Ask for a stricter tolerance, and look for lengths, masses or "
              "forces of a wrong order of size.");
}

}  // namespace clevis::mechanism
