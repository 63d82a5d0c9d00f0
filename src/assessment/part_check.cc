#include "assessment/part_check.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "assessment/impact/impact_check.h"
#include "assessment/judge/model_band.h"
#include "assessment/judge/verdict.h"
#include "assessment/ladder/degree_climb.h"
#include "assessment/ladder/degree_ladder.h"
#include "assessment/ladder/rung_result.h"
#include "assessment/models/model_choice.h"
#include "assessment/models/model_error.h"
#include "assessment/models/revolution_model.h"
#include "assessment/models/rung.h"
#include "assessment/notes/beam_comparison.h"
#include "assessment/notes/case_notes.h"
#include "assessment/notes/facet_doubt.h"
#include "assessment/notes/part_notes.h"
#include "assessment/stability/buckling_check.h"
#include "assessment/stability/sharing_check.h"
#include "assessment/vibration/load_pace.h"
#include "assessment/vibration/vibration_check.h"
#include "base/stopwatch.h"
#include "part/verdict.h"

namespace clevis::assessment {
namespace {

template <int dim>
PartAssessment run_rung(const PartJob& job, const mesh::PartMesh<dim>& mesh,
                        const Rung<dim>& rung,
                        const std::vector<LoadSet>& governing = {}) {
  PartSeconds seconds;
  const auto ladder = climb_degrees<dim>(job, mesh, rung, governing, seconds);
  return assess<dim>(job, rung, ladder, seconds);
}

bool is_held(const PartJob& job) {
  return std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
    return !set.fixed.empty() || !set.foundations.empty();
  });
}

/// Whether a higher rung has nothing to add. Of a free part a slow sequence of
/// degrees that looks singular may only want a higher one.
bool is_settled(const PartJob& job, const PartResult& result) {
  if (result.peak.verdict != PeakVerdict::kSingular) {
    return result.peak.verdict == PeakVerdict::kConverged;
  }
  return is_held(job) &&
         (!job.part.limits.exclude_singular_zones || !result.peak_outside ||
          result.peak_outside->verdict == PeakVerdict::kConverged);
}

/// Nothing if a higher rung is there and the error of the model alone is above
/// the tolerance. A held part is climbed first: a stress without bound needs no
/// better model.
std::optional<PartAssessment> run_plane_stress(
    const PartJob& job, const PlateModel& plate,
    const std::vector<LoadSet>& governing) {
  const bool may_skip = plate.suits_layers && !is_held(job) &&
                        job.model != ModelChoice::kPlaneStress;
  auto rung = plane_stress_rung(plate.mesh);
  if (may_skip) {
    if (plane_stress_is_far(job, plate.quadrangles, governing))
      return std::nullopt;
    rung.model_error = plane_stress_error(job, plate.quadrangles, governing);
    if (rung.model_error > job.tolerance) return std::nullopt;
  }
  auto assessment = run_rung<2>(job, plate.mesh, rung, governing);
  PartResult& result = assessment.result;
  if (!may_skip && result.peak.value > 0.0) {
    rung.model_error = plane_stress_error(job, plate.quadrangles, governing);
  }
  add_model_error(job.tolerance, rung.model_error, result);
  return assessment;
}

/// Looks closer where that is cheap or asked for.
int lattice_for(const PartJob& job) {
  constexpr double kFine = 0.005;
  constexpr std::size_t kFew = 10;
  std::size_t instants = 0;
  for (const LoadSet& set : job.load_sets) {
    instants += set.history.instants.size();
  }
  return instants <= kFew || job.tolerance < kFine ? 8 : 4;
}

/// Whether hexahedra can be solved: supports of the plane alone leave them
/// free to leave it.
bool is_held_in_space(const PartJob& job) {
  return std::ranges::all_of(job.load_sets, [](const LoadSet& set) {
    return set.fixed.empty() || std::ranges::any_of(set.fixed, [](auto& f) {
             return f.second[2];
           });
  });
}

PartAssessment run_layered(const PartJob& job, const PlateModel& plate,
                           const std::vector<LoadSet>& governing) {
  constexpr double kShare = 0.5;  // of the tolerance, for the model
  const auto choice =
      choose_terms(job, plate.quadrangles, governing, kShare * job.tolerance);
  auto rung = layered_rung(plate.quadrangles, choice.terms, lattice_for(job));
  rung.model_error = choice.model_error;
  auto assessment = run_rung<3>(job, job.mesh, rung, governing);
  assessment.result.cells = static_cast<int>(plate.quadrangles.cells.size());
  add_model_error(job.tolerance, choice.model_error, assessment.result);
  return assessment;
}

PartAssessment run_revolution(const PartJob& job,
                              const mesh::Revolution& solid) {
  const auto progress = std::make_shared<RevolutionProgress>();
  auto assessment =
      run_rung<3>(job, job.mesh, revolution_rung(solid, progress));
  PartResult& result = assessment.result;
  result.model =
      fmt::format("axisymmetric, {} harmonic{}, p = {}", progress->harmonics,
                  progress->harmonics == 1 ? "" : "s", progress->degree);
  result.cells = static_cast<int>(solid.meridian.cells.size());
  add_model_error(job.tolerance, 0.0, result);
  if (result.peak.value > 0.0) {
    result.stopped_because += fmt::format(
        "; higher harmonics bring {:.2g} % at most, counted in the first",
        100.0 * progress->truncation / result.peak.value);
  }
  return assessment;
}

/// The lowest rung that meets the tolerance, or the highest that the part
/// and the job admit.
PartAssessment climb(const PartJob& job) {
  PartSeconds seconds;
  const auto solid = revolution_model(job);
  if (solid && job.model == ModelChoice::kRevolution) {
    return run_revolution(job, *solid);
  }
  const auto plate = plate_model(job);
  std::vector<LoadSet> governing;
  if (plate) {
    governing =
        governing_loads(job, plate->quadrangles, plate->suits_plane_stress);
  }
  if (plate && plate->suits_plane_stress &&
      job.model != ModelChoice::kLayered) {
    auto assessment = run_plane_stress(job, *plate, governing);
    const bool is_last = !plate->suits_layers && !is_held_in_space(job);
    if (assessment && (is_settled(job, assessment->result) || is_last ||
                       job.model == ModelChoice::kPlaneStress)) {
      return std::move(*assessment);
    }
    if (assessment) seconds = assessment->result.seconds;
  }
  if (plate && plate->suits_layers) {
    auto assessment = run_layered(job, *plate, governing);
    add_seconds(seconds, assessment.result.seconds);
    const PeakStress& peak = assessment.result.peak;
    // Where the degree falls short hexahedra of the same mesh do too.
    if (is_settled(job, assessment.result) ||
        job.model == ModelChoice::kLayered || !is_held_in_space(job) ||
        peak.verdict == PeakVerdict::kSingular ||
        peak.model_error < job.tolerance * peak.value) {
      return assessment;
    }
    seconds = assessment.result.seconds;
  }
  if (solid) {
    auto assessment = run_revolution(job, *solid);
    add_seconds(seconds, assessment.result.seconds);
    return assessment;
  }
  auto assessment = run_rung<3>(job, job.mesh, solid_rung(job.mesh));
  add_seconds(seconds, assessment.result.seconds);
  add_model_error(job.tolerance, 0.0, assessment.result);
  return assessment;
}

/// What loads at rest and in motion do to the part, and its blows.
PartAssessment climb_all(const PartJob& job, CheckedBlows& blows) {
  if (job.load_sets.empty() && blows.assessment) {
    return std::move(*blows.assessment);
  }
  PartAssessment found = climb(job);
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
                   " bounces, and its course hangs on little things: give the "
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
std::optional<double> mean_strain_energy(const PartJob& job,
                                         const std::vector<InstantRow>& rows) {
  if (job.load_sets.empty()) return std::nullopt;
  // The motion comes first, then cases at 0 s, then what others have joined.
  const auto& instants = job.load_sets.front().history.instants;
  const auto start =
      std::ranges::find_if(rows, [&instants](const InstantRow& row) {
        return row.label == instants[0].label && row.time == instants[0].time;
      });
  if (start == rows.end()) return std::nullopt;
  const auto count = std::min(std::ssize(instants), rows.end() - start);
  double integral = 0.0;  // [J s]
  double end = start->time;
  for (auto row = start + 1; row != start + count && row->time >= end; ++row) {
    integral += 0.5 * (row->time - end) *
                (row->strain_energy + (row - 1)->strain_energy);
    end = row->time;
  }
  if (end == start->time) return std::nullopt;
  return integral / (end - start->time);
}

void note_energy_over_time(const PartJob& job,
                           const std::vector<InstantRow>& rows,
                           PartResult& result) {
  const auto largest =
      std::ranges::max_element(rows, {}, &InstantRow::strain_energy);
  if (largest == rows.end()) return;
  result.strain_energy_instant = largest->time;
  result.mean_strain_energy = mean_strain_energy(job, rows);
}

}  // namespace

PartAssessment check_part(const PartJob& given) {
  Stopwatch watch;
  CheckedBlows blows = check_blows(given);
  PartAssessment assessment = climb_all(given, blows);
  PartJob job = given;  // with the blows as loads at rest, for beam theory
  job.load_sets.insert(job.load_sets.end(), blows.at_rest.begin(),
                       blows.at_rest.end());
  PartResult& result = assessment.result;
  result.name = job.part.name;
  result.notes.insert(result.notes.end(), job.notes.begin(), job.notes.end());
  result.mass = job.mass.mass;
  note_energy_over_time(given, assessment.fields.history, result);
  for (const LoadSet& set : job.load_sets) {
    result.notes.insert(result.notes.end(), set.history.notes.begin(),
                        set.history.notes.end());
  }
  note_cases(given, result);
  add_facet_doubt(job, assessment.fields, result);
  result.beam = compare_with_beam(job, result);
  BucklingCheck buckling = check_buckling(job);
  result.buckling = std::move(buckling.result);
  result.buckling.euler = result.beam.buckling_safety;
  result.buckling.strut_is_longer = job.buckling_length.has_value();
  assessment.fields.buckling = std::move(buckling.shape);
  const double judged = governing_stress(job.part, result);
  result.safety_factor =
      judged > 0.0 ? job.part.material.yield_strength / judged : 0.0;
  finish_impacts(std::move(blows.impacts), result);
  judge_paces(job, result);
  check_vibration(job, result);
  check_sharing(given, result);
  judge(job.part, result);
  explain_unsettled(result);
  for (std::string& note : part_notes(job)) {
    result.notes.push_back(std::move(note));
  }
  result.seconds.total = watch.lap();
  return assessment;
}

}  // namespace clevis::assessment
