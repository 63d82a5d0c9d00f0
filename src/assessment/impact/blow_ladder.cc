#include "assessment/impact/blow_ladder.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "assessment/judge/model_band.h"
#include "assessment/ladder/degree_climb.h"
#include "assessment/ladder/degree_ladder.h"
#include "assessment/ladder/model_result.h"
#include "elasticity/problem/elastic_problem.h"

namespace clevis::assessment {
namespace {

/// The candidate samples as the instants of a history, without loads: these are
/// in the answer.
LoadSet instants_of(const ImpactJob& impact, const BlowTimes& times) {
  LoadSet set;
  set.fixed = impact.fixed;
  for (const int i : times.candidates) {
    loads::InstantLoad instant;
    instant.label = impact.strike.name;
    instant.time = times.time[i];
    set.history.instants.push_back(instant);
  }
  return set;
}

void judge_band(PeakStress& peak) {
  constexpr double kWide = 0.1;
  const double half =
      std::max(peak.band_high - peak.value, peak.value - peak.band_low);
  if (peak.verdict == PeakVerdict::kNotConverged &&
      half <= kWide * peak.value) {
    peak.verdict = PeakVerdict::kConverged;
  }
}

/// @param impact  name of the blow.
void add_time_error(const BlowTimes& times, const std::string& impact,
                    SupportStress& held) {
  held.band_low = std::max(
      0.0, held.band_low - (times.error + times.root_below) * held.value);
  held.band_high +=
      (times.error + times.root_above + times.root_later - 1.0) * held.value;
  if (times.spread) {
    widen(times.spread->root_low, times.spread->root_high, held.band_low,
          held.band_high);
  }
  held.label = fmt::format("impact {}", impact);
}

void add_time_error(const BlowTimes& times, PeakStress& peak) {
  const double below = times.error + times.below;
  const double above = times.error + times.above;
  peak.band_low = std::max(0.0, peak.band_low - below * peak.value);
  peak.band_high += (above + times.later - 1.0) * peak.value;
  if (times.spread) {
    widen(times.spread->stress_low, times.spread->stress_high, peak.band_low,
          peak.band_high);
  }
  peak.model_error += std::max(below, above) * peak.value;
}

}  // namespace

template <int dim>
PartAssessment climb_blow(const PartJob& job, const ImpactJob& impact,
                          const BlowTimes& times, FeModel<dim> model,
                          StruckFaces<dim>& faces) {
  PartJob blow = job;
  blow.load_sets = {instants_of(impact, times)};
  ImpactJob timed = impact;
  timed.strike.duration = times.time[times.time.size() - 1];
  timed.samples = times.samples();
  timed.front = times.front;
  std::optional<StruckFaces<dim>> graded;
  model.mesh = &faces.mesh();
  // Finer solutions nearby are for loads at rest.
  model.looks_nearby = model.looks_at_places = false;
  model.solve = [&](const elasticity::ElasticProblem<dim>& problem,
                    int degree) {
    const bool is_graded =
        problem.mesh.cells.size() != faces.mesh().cells.size();
    if (is_graded && !graded) graded.emplace(problem.mesh);
    auto& face = (is_graded ? *graded : faces).get(blow, timed, degree);
    const auto response = face.solve(
        timed.strike, strike_options(job, dynamics::Route::kAuto, timed));
    return at_samples(response.basis, times.candidates);
  };
  PartSeconds seconds;
  const auto ladder = climb_degrees<dim>(blow, model, {}, seconds);
  PartAssessment found = assess<dim>(blow, model, ladder, seconds);
  add_model_error(job.tolerance, model.model_error, found.result);
  for (PeakStress* peak : each_peak(found.result)) {
    judge_band(*peak);
    add_time_error(times, *peak);
  }
  if (found.result.held) {
    add_time_error(times, impact.strike.name, *found.result.held);
  }
  return found;
}

template PartAssessment climb_blow<2>(const PartJob&, const ImpactJob&,
                                      const BlowTimes&, FeModel<2>,
                                      StruckFaces<2>&);
template PartAssessment climb_blow<3>(const PartJob&, const ImpactJob&,
                                      const BlowTimes&, FeModel<3>,
                                      StruckFaces<3>&);

}  // namespace clevis::assessment
