#include "assessment/ladder/deflection_band.h"

#include <algorithm>

#include "assessment/judge/time_sampling_error.h"
#include "assessment/ladder/load_accuracy.h"
#include "stress/peaks/slow_sequence.h"

namespace clevis::assessment {

template <int dim>
void DeflectionWatch::take(const std::vector<LoadSet>& sets,
                           const Level<dim>& level) {
  Degree& degree = degrees_.emplace_back();
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
    if (deflections.maxCoeff() < degree.largest) continue;
    degree.largest = deflections.maxCoeff();
    degree.time_error = time_sampling_error(sets[s].history, deflections) +
                        inexact_deflection<dim>(level, s) * degree.largest;
  }
}

bool DeflectionWatch::all_have(const Instant& instant) const {
  return std::ranges::all_of(degrees_, [&](const Degree& degree) {
    return degree.values.contains(instant);
  });
}

DeflectionError DeflectionWatch::error() const {
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
  const double error = stress::displacement_error(sequence);
  return {largest < last.largest ? kOtherInstant * error : error,
          last.time_error / last.largest};
}

DeflectionBand DeflectionWatch::band() const {
  const double largest = degrees_.back().largest;
  const DeflectionError off = error();
  return {std::max(0.0, 1.0 - off.mesh) * largest,
          (1.0 + off.mesh + off.time) * largest};
}

double DeflectionWatch::probe_error(const std::string& label,
                                    const std::vector<double>& values) const {
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

template void DeflectionWatch::take<2>(const std::vector<LoadSet>&,
                                       const Level<2>&);
template void DeflectionWatch::take<3>(const std::vector<LoadSet>&,
                                       const Level<3>&);

}  // namespace clevis::assessment
