#include "assessment/part_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "assessment/buckling/buckling_check.h"
#include "assessment/impact/impact_check.h"
#include "assessment/judge/model_band.h"
#include "assessment/ladder/degree_climb.h"
#include "assessment/ladder/degree_ladder.h"
#include "assessment/ladder/model_result.h"
#include "assessment/models/model_list.h"
#include "assessment/notes/beam_comparison.h"
#include "assessment/notes/case_notes.h"
#include "assessment/notes/facet_doubt.h"
#include "assessment/notes/part_notes.h"
#include "assessment/notes/round_doubt.h"
#include "assessment/notes/shear_doubt.h"
#include "assessment/notes/zone_doubt.h"
#include "assessment/second_order/second_order_check.h"
#include "assessment/sharing/sharing_check.h"
#include "assessment/verdict/governing_peak.h"
#include "assessment/verdict/hidden_stress.h"
#include "assessment/verdict/verdict.h"
#include "assessment/vibration/moved_frequencies.h"
#include "assessment/vibration/pulsing_loads.h"
#include "assessment/vibration/vibration_check.h"
#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "part/verdict.h"

namespace clevis::assessment {
namespace {

/// Whether a better model has nothing to add. Of a free part a slow sequence of
/// degrees that looks singular may only want a higher one.
bool is_settled(const PartJob& job, const PartResult& result) {
  if (result.peak.verdict != PeakVerdict::kSingular) {
    return result.peak.verdict == PeakVerdict::kConverged;
  }
  return is_held(job) &&
         (!job.part.limits.exclude_singular_zones || !result.peak_outside ||
          result.peak_outside->verdict == PeakVerdict::kConverged);
}

template <int dim>
PartAssessment assess_by(const PartJob& job, const FeModel<dim>& model,
                         const std::vector<LoadSet>& governing) {
  PartSeconds seconds;
  const auto ladder = climb_degrees<dim>(job, model, governing, seconds);
  return assess<dim>(job, model, ladder, seconds);
}

/// Nothing if the error of the model alone is above the tolerance and a better
/// one suits.
/// @param seconds  what the choice of the model takes is added here.
std::optional<PartAssessment> solve_model(const Model& entry,
                                          const PartShape& shape,
                                          PartSeconds& seconds) {
  const PartJob& job = shape.job();
  Stopwatch watch;
  const auto settings = entry.settings(shape);
  seconds.choose += watch.lap();
  if (!settings) return std::nullopt;
  const auto solve = [&](const auto& model) {
    PartAssessment assessment = assess_by(job, model, settings->governing);
    PartResult& result = assessment.result;
    watch.lap();
    const double error = settings->error           ? *settings->error
                         : result.peak.value > 0.0 ? entry.error(shape)
                                                   : 0.0;
    seconds.choose += watch.lap();
    add_model_error(job.tolerance, error, result);
    if (model.remark) model.remark(result);
    return assessment;
  };
  return std::visit(solve, entry.make(shape, *settings));
}

/// By the cheapest model that meets the tolerance, or the best that the part
/// and the job admit.
/// @throws Error F007 if not even one model has few enough unknowns.
PartAssessment solve_models(const PartJob& job) {
  const PartShape shape(job);
  Stopwatch watch;
  const auto models = models_for(shape);
  PartSeconds seconds;
  seconds.choose = watch.lap();
  std::optional<PartAssessment> found;
  std::optional<Error> refused;
  std::string left_out;
  for (const Model* model : models) {
    std::optional<PartAssessment> assessment;
    try {
      assessment = solve_model(*model, shape, seconds);
    } catch (const Error& error) {
      if (error.code() != "F007") throw;
      left_out +=
          fmt::format("; {} left out, {}", model->traits.name, error.problem());
      if (!refused) refused = error;
      if (found) break;
      continue;  // a model that is solved as it is may have fewer unknowns
    }
    if (!assessment) continue;
    found = std::move(assessment);
    PartResult& result = found->result;
    add_seconds(seconds, result.seconds);
    if (is_settled(job, result) || !model->next_may_help(shape, result)) break;
    seconds = result.seconds;
  }
  if (!found) throw Error(*refused);
  found->result.stopped_because += left_out;
  found->result.seconds.choose = seconds.choose;  // of models that failed, too
  return std::move(*found);
}

/// Assessment of the part under loads at rest and in motion, and under blows.
PartAssessment solve_all(const PartJob& job, CheckedBlows& blows) {
  if (job.load_sets.empty() && blows.assessment) {
    return std::move(*blows.assessment);
  }
  PartAssessment found = solve_models(job);
  return blows.assessment ? join(std::move(found), std::move(*blows.assessment))
                          : std::move(found);
}

void explain_unsettled(PartResult& result) {
  if (result.verdict != part::Verdict::kNotJudged) return;
  for (const ImpactResult& impact : result.impacts) {
    if (impact.is_cut) {
      result.why = "the duration of impact " + impact.name +
                   " ends while the striker still presses, its peak may come "
                   "later: give a longer one, or leave the key out";
      return;
    }
    if (impact.refinement.settles) continue;
    if (impact.spread > 0.0) {
      result.why = "the striker of impact " + impact.name +
                   " bounces, and its response is chaotic: give the "
                   "part its damping";
      return;
    }
    result.why = "the stress of impact " + impact.name +
                 " does not settle, its front is shorter than the mesh "
                 "carries: mesh finer along the wave's way, or give the "
                 "contact its stiffness";
    return;
  }
}

/// By trapezoids between the instants of the motion; absent without one [J].
std::optional<double> mean_strain_energy(const std::vector<InstantRow>& rows) {
  // The motion is the first set's beginning; its cases stand behind it at 0 s.
  const InstantRow* first = nullptr;
  const InstantRow* last = nullptr;
  double integral = 0.0;  // [J s]
  for (const InstantRow& row : rows) {
    if (row.load_set != 0) continue;
    if (last == nullptr) {
      first = &row;
    } else {
      if (row.time < last->time) break;
      integral += 0.5 * (row.time - last->time) *
                  (row.strain_energy + last->strain_energy);
    }
    last = &row;
  }
  if (first == last) return std::nullopt;
  if (last->time == first->time) return std::nullopt;
  return integral / (last->time - first->time);
}

/// @param repeats  whether loads of the motion are left out that repeat others.
void note_energy_over_time(const std::vector<InstantRow>& rows, bool repeats,
                           PartResult& result) {
  const auto largest =
      std::ranges::max_element(rows, {}, &InstantRow::strain_energy);
  if (largest == rows.end()) return;
  result.strain_energy_instant = largest->time;
  // Of loads that repeat others no row is known.
  if (!repeats) result.mean_strain_energy = mean_strain_energy(rows);
}

/// What of the mechanism does not count where the part may buckle.
/// @param position  of BucklingCheck.
void note_left_out(const PartJob& job,
                   const elasticity::BucklingOnSprings::Position& position,
                   PartResult& result) {
  if (position.is_open) {
    result.notes.push_back(
        "where it stands its loads push it over, but for contacts that let go "
        "at times: see that these press, for its buckling does not count them");
  }
  if (position.stands || result.buckling.factor.value_or(HUGE_VAL) >=
                             enough_buckling(job.part.limits)) {
    return;
  }
  for (const LoadSet& set : job.load_sets) {
    if (!set.history.hold || !set.fixed.empty()) continue;
    const auto names =
        set.history.hold_that_lasts(set.history.hold_time).left_out;
    if (names.empty()) continue;
    result.notes.push_back(fmt::format(
        "it moves, and {}, which swing{} other bodies of the mechanism by "
        "themselves, do{} not count in its buckling",
        fmt::join(names, ", "), names.size() > 1 ? "" : "s",
        names.size() > 1 ? "" : "es"));
    return;
  }
}

/// Before all others: a number that is wrong by its unit makes them idle.
void tell_first(const std::vector<std::string>& notes, PartResult& result) {
  result.notes.insert(result.notes.begin(), notes.begin(), notes.end());
}

}  // namespace

PartAssessment check_part(const PartJob& given) {
  Stopwatch watch;
  CheckedBlows blows = check_blows(given);
  PartAssessment assessment = solve_all(given, blows);
  PartJob job = given;  // with the blows as loads at rest, for beam theory
  job.load_sets.insert(job.load_sets.end(), blows.at_rest.begin(),
                       blows.at_rest.end());
  add_facet_doubt(job, assessment.fields, assessment.result);
  add_round_doubt(job, assessment.result);
  add_zone_doubt(job, assessment.result);
  const double solved = watch.lap();
  const bool is_late = given.late_after && solved > *given.late_after;
  if (!given.judges_open_peak && !is_late &&
      judged_peak(assessment.result).verdict == PeakVerdict::kNotConverged) {
    assessment.result.seconds.total = solved;
    return assessment;
  }
  add_shear_doubt(job, assessment.fields, assessment.result);
  PartResult& result = assessment.result;
  result.name = job.part.name;
  result.notes.insert(result.notes.end(), job.notes.begin(), job.notes.end());
  result.mass = job.mass.mass;
  note_energy_over_time(
      assessment.fields.history,
      std::ranges::any_of(job.load_sets,
                          [](const LoadSet& set) {
                            return !set.history.repeats.empty();
                          }),
      result);
  for (const LoadSet& set : job.load_sets) {
    result.notes.insert(result.notes.end(), set.history.notes.begin(),
                        set.history.notes.end());
  }
  note_cases(given, result);
  result.beam = compare_with_beam(job, result);
  const double judged = governing_stress(job.part, result);
  result.safety_factor =
      judged > 0.0 ? job.part.material.yield_strength / judged : 0.0;
  finish_impacts(std::move(blows.impacts), result);
  job.tell("vibration");
  HeldMotions held(job);
  check_vibration(job, assessment.fields.history, held, result);
  doubt_spun_frequencies(job, held, result);
  job.tell("buckling and notes");
  BucklingModel model(job);
  BucklingCheck buckling = check_buckling(job, result.swings, model);
  result.buckling = std::move(buckling.result);
  result.buckling.euler = result.beam.buckling_safety;
  result.buckling.strut_is_longer = job.buckling_length.has_value();
  assessment.fields.buckling = std::move(buckling.shape);
  doubt_moved_frequencies(job, held, buckling.stiffening, result);
  doubt_pulsing_loads(job, result);
  // Its equations are those of the hold.
  const bool rises = buckling.on_springs.rises();
  if (!rises) {
    check_second_order(job, assessment.fields.history,
                       buckling.of_lowest_degree, held, model, result);
  }
  const double own_low = result.buckling.band_low;
  if (count_springs(job, buckling.on_springs, buckling.of_lowest_degree,
                    result.buckling) ||
      rises) {
    bound_on_springs(buckling.on_springs, result);
  }
  count_standing(buckling.standing, own_low, result.buckling);
  check_sharing(given, result);
  note_left_out(job, buckling.standing.position, result);
  judge(job.part, result);
  explain_unsettled(result);
  tell_first(part_notes(job), result);
  const double stressed = std::max(judged, governing_peak(result).value);
  tell_first(
      strength_notes(judged > 0.0 ? job.part.material.yield_strength / stressed
                                  : 0.0),
      result);
  result.seconds.total = solved + watch.lap();
  assessment.is_judged = true;
  return assessment;
}

}  // namespace clevis::assessment
