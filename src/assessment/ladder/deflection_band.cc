#include "assessment/ladder/deflection_band.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/judge/time_sampling_error.h"
#include "assessment/ladder/load_accuracy.h"
#include "stress/peaks/slow_sequence.h"

namespace clevis::assessment {

namespace {

/// Of each node [m].
template <int dim>
Eigen::VectorXd lengths(const Eigen::VectorXd& displacement) {
  return displacement.reshaped(dim, displacement.size() / dim)
      .colwise()
      .norm()
      .transpose();
}

template <int dim>
elasticity::NodalField<dim> displacement_at(
    const elasticity::DisplacementBasis<dim>& basis, Eigen::Index instant) {
  return {basis.discretization,
          basis.columns * basis.coefficients.col(instant)};
}

/// Of what a place has moved on by: 3.4 is left in a clamped layer of 20 x 20 x
/// 2 mm in 2 x 2 x 1 cells.
constexpr double kLeft = 4.0;

}  // namespace

template <int dim>
double DeflectionWatch<dim>::growth_after(const Degree& before,
                                          const std::vector<LoadSet>& sets,
                                          const Level<dim>& level) {
  if (!before.farthest) return 0.0;
  const auto& [label, time] = before.farthest->instant;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const auto& instants = sets[s].history.instants;
    const auto found = std::ranges::find_if(instants, [&](const auto& instant) {
      return instant.label == label && instant.time == time;
    });
    if (found == instants.end()) continue;
    const auto now =
        displacement_at<dim>(*level.bases[s], found - instants.begin());
    // Solids of revolution take more cells round with higher harmonics.
    if (now.discretization.cells() !=
        before.farthest->field.discretization.cells()) {
      return 0.0;
    }
    const Eigen::VectorXd length = lengths<dim>(now.values);
    const double largest = length.maxCoeff();
    if (!(largest > 0.0)) return 0.0;
    const Eigen::VectorXd before_then = elasticity::carried_over<dim>(
        before.farthest->field, now.discretization);
    const Eigen::VectorXd change = lengths<dim>(now.values - before_then);
    return (length + kLeft * change).maxCoeff() / largest - 1.0;
  }
  return 0.0;
}

template <int dim>
void DeflectionWatch<dim>::take(const std::vector<LoadSet>& sets,
                                const Level<dim>& level) {
  Degree degree;
  degree.degree = level.member.degree;
  degree.dofs = level.member.dofs;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const auto& instants = sets[s].history.instants;
    const Eigen::VectorXd& deflections = level.deflections[s].of_instant;
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      degree.values[{instants[i].label, instants[i].time}] = {
          deflections[at], level.bases[s]->strain_energy[at]};
    }
    Eigen::Index most = 0;
    const double largest = deflections.maxCoeff(&most);
    if (largest < degree.largest) continue;
    degree.largest = largest;
    degree.time_error = time_sampling_error(sets[s].history, deflections) +
                        inexact_deflection<dim>(level, s) * degree.largest;
    const auto& instant = instants[static_cast<std::size_t>(most)];
    degree.farthest = {{instant.label, instant.time},
                       displacement_at<dim>(*level.bases[s], most)};
  }
  if (!degrees_.empty()) {
    degree.may_grow = growth_after(degrees_.back(), sets, level);
  }
  degrees_.push_back(std::move(degree));
}

template <int dim>
bool DeflectionWatch<dim>::all_have(const Instant& instant) const {
  return std::ranges::all_of(degrees_, [&](const Degree& degree) {
    return degree.values.contains(instant);
  });
}

template <int dim>
DeflectionError DeflectionWatch<dim>::error() const {
  constexpr double kOtherInstant = 2.0;
  const Degree& last = degrees_.back();
  if (!(last.largest > 0.0)) return {};
  const Instant* instant = nullptr;
  double largest = -1.0;
  for (const auto& [key, value] : last.values) {
    if (value.deflection <= largest || !all_have(key)) continue;
    largest = value.deflection;
    instant = &key;
  }
  std::vector<stress::DisplacementValue> sequence;
  for (const Degree& degree : degrees_) {
    if (instant == nullptr) break;
    const Value& value = degree.values.at(*instant);
    sequence.push_back(
        {degree.degree, degree.dofs, value.deflection, value.energy});
  }
  const double error =
      std::max(stress::displacement_error(sequence), last.may_grow);
  return {largest < last.largest ? kOtherInstant * error : error,
          last.time_error / last.largest};
}

template <int dim>
DeflectionBand DeflectionWatch<dim>::band() const {
  const double largest = degrees_.back().largest;
  const DeflectionError off = error();
  return {std::max(0.0, 1.0 - off.mesh) * largest,
          (1.0 + off.mesh + off.time) * largest};
}

template <int dim>
double DeflectionWatch<dim>::probe_error(
    const std::string& label, const std::vector<double>& values) const {
  std::vector<stress::DisplacementValue> sequence;
  for (std::size_t k = 0; k < degrees_.size(); ++k) {
    const auto instant =
        std::ranges::find_if(degrees_[k].values, [&](const auto& entry) {
          return entry.first.first == label;
        });
    const double energy =
        instant == degrees_[k].values.end() ? 0.0 : instant->second.energy;
    sequence.push_back(
        {degrees_[k].degree, degrees_[k].dofs, values[k], energy});
  }
  return stress::displacement_error(sequence);
}

template class DeflectionWatch<2>;
template class DeflectionWatch<3>;

}  // namespace clevis::assessment
