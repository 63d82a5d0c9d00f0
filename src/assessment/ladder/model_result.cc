#include "assessment/ladder/model_result.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "assessment/judge/finite_motion.h"
#include "assessment/ladder/probe_band.h"
#include "base/messages/errors.h"
#include "stress/displacement/deflection.h"
#include "stress/displacement/finite_motion.h"
#include "stress/peaks/energy_error.h"

namespace clevis::assessment {
namespace {

PeakVerdict to_peak_verdict(stress::Convergence convergence) {
  switch (convergence) {
    case stress::Convergence::kConverged:
      return PeakVerdict::kConverged;
    // Growth alone is no proof: shape and supports show where it is due.
    case stress::Convergence::kSingular:
    case stress::Convergence::kNotConverged:
      break;
  }
  return PeakVerdict::kNotConverged;
}

/// Where a peak stands on the lattice of a load set.
struct PeakPlace {
  std::size_t set{};
  stress::FieldPoint at;
  int instant{};
};

template <int dim>
void fill_peak(const PartJob& job, const DegreeLadder<dim>& ladder,
               const stress::Band& band, const PeakPlace& place,
               PeakStress& peak) {
  const Level<dim>& level = ladder.level;
  const auto& discretization = level.bases[place.set]->discretization;
  const int subdivisions = level.histories[place.set].subdivisions;
  peak.value = band.value;
  peak.band_low = std::max(0.0, band.low);
  peak.band_high = band.high;
  peak.verdict = to_peak_verdict(band.verdict);
  peak.has_band = (ladder.sequence.size() >= 3 || ladder.two_are_enough) &&
                  band.verdict != stress::Convergence::kSingular;
  const loads::LoadHistory& loaded = job.load_sets[level.set].history;
  // Beside what is unseen, slides that travel between instants are in doubt.
  peak.shares.change_points =
      loaded.at_change_points *
      std::min(ladder.time_error, loaded.unseen * band.value);
  peak.shares.time = ladder.time_error - peak.shares.change_points;
  peak.at = stress::position<dim>(discretization, place.at, subdivisions);
  peak.group =
      stress::surface_group<dim>(discretization, place.at, subdivisions);
  const auto& instant =
      job.load_sets[place.set]
          .history.instants[static_cast<std::size_t>(place.instant)];
  peak.instant = instant.time;
  peak.label = instant.label;
}

/// Where finer solutions nearby found it, if they did.
template <int dim>
PeakPlace place_of(const DegreeLadder<dim>& ladder, const PeakPlace& solved) {
  if (!ladder.nearby) return solved;
  return {ladder.nearby->set, ladder.nearby->at, ladder.nearby->instant};
}

template <int dim>
void fill_nearby(const DegreeLadder<dim>& ladder, PeakStress& peak) {
  peak.jump = ladder.jump;
  if (ladder.nearby) peak.degree_nearby = ladder.nearby->degree;
}

/// Zones, and where one governs the peak away from those that do.
template <int dim>
void fill_zones(const PartJob& job, const DegreeLadder<dim>& ladder,
                PartResult& result) {
  const Level<dim>& level = ladder.level;
  const ZoneTracker<dim>& zones = ladder.zones;
  result.singular_zones = zones.results();
  for (ZoneResult& zone : result.singular_zones) {
    zone.has_section = std::ranges::any_of(level.support_sections,
                                           [&](const std::string& group) {
                                             return zone.edge_of == group;
                                           });
  }
  if (!zones.is_singular()) return;
  result.peak.verdict = PeakVerdict::kSingular;
  const OutsidePeak& last = zones.outside().back();
  PeakStress& outside = result.peak_outside.emplace();
  fill_peak<dim>(job, ladder, ladder.outer_band,
                 place_of(ladder, {last.set, last.at, last.instant}), outside);
  fill_nearby<dim>(ladder, outside);
  outside.discretization_error = std::max(outside.band_high - outside.value,
                                          outside.value - outside.band_low);
  for (const OutsidePeak& peak : zones.outside()) {
    outside.sequence.push_back(peak.member);
  }
}

template <int dim>
void fill_deflection(const PartJob& job, const DegreeLadder<dim>& ladder,
                     PartResult& result) {
  const Level<dim>& level = ladder.level;
  for (std::size_t s = 0; s < level.bases.size(); ++s) {
    const stress::Deflection& deflection = level.deflections[s];
    result.strain_energy = std::max(result.strain_energy,
                                    level.bases[s]->strain_energy.maxCoeff());
    if (s > 0 && deflection.value <= result.deflection) continue;
    result.deflection = deflection.value;
    result.deflection_at = deflection.at;
    const loads::InstantLoad& instant =
        job.load_sets[s]
            .history.instants[static_cast<std::size_t>(deflection.instant)];
    result.deflection_instant = instant.time;
    result.deflection_label = instant.label;
    result.deflection_set = s;
  }
  const DeflectionBand band = ladder.deflections.band();
  result.deflection_low = band.low;
  result.deflection_high = band.high;
}

/// The label is of what is farther beyond its bound.
template <int dim>
void fill_motion(const PartJob& job, const Level<dim>& level,
                 FiniteMotion& result) {
  double farthest = -1.0;
  for (std::size_t s = 0; s < level.bases.size(); ++s) {
    const auto motion = stress::field_motion<dim>(*level.bases[s]);
    const double turn = motion.rotation / kLargestRotation;
    const double strain = motion.strain / kLargestStrain;
    result.rotation = std::max(result.rotation, motion.rotation);
    result.strain = std::max(result.strain, motion.strain);
    if (std::max(turn, strain) <= farthest) continue;
    farthest = std::max(turn, strain);
    const int instant =
        turn < strain ? motion.strain_instant : motion.rotation_instant;
    result.label = job.load_sets[s]
                       .history.instants[static_cast<std::size_t>(instant)]
                       .label;
  }
}

template <int dim>
void fill_checks(const Level<dim>& level, SelfChecks& checks) {
  for (const auto& basis : level.bases) {
    checks.equilibrium = std::max(
        {checks.equilibrium, basis->checks.balance, basis->checks.equilibrium});
    checks.residual = std::max(checks.residual, basis->checks.residual);
    checks.energy = std::max(checks.energy, basis->checks.energy);
    checks.compression =
        std::max(checks.compression, basis->checks.compression);
  }
}

/// Error of strains in the smallest cell by the positions' round-off [1].
template <int dim>
double strain_round_off(const elasticity::Discretization<dim>& discretization) {
  double farthest = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& points : discretization.cell_points) {
    farthest = std::max(farthest, points.cwiseAbs().maxCoeff());
    smallest = std::min(
        smallest,
        (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm());
  }
  return 64.0 * std::numeric_limits<double>::epsilon() * farthest / smallest;
}

/// The field that is written, evaluated afresh, must have the reported field
/// maximum, which is the peak where no finer solution nearby gives it.
/// @return the largest stress component at that instant [Pa].
template <int dim>
double check_reported_peak(const PartJob& job, const Level<dim>& level,
                           PartResult& result) {
  const auto field = stress::instant_field<dim>(
      *level.governing, job.part.material, level.history().subdivisions,
      level.history().peak_instant);
  double largest = 0.0;
  double component = 0.0;
  for (const auto& cell : field.stress) {
    largest = std::max(largest, stress::von_mises(cell).maxCoeff());
    component = std::max(component, cell.cwiseAbs().maxCoeff());
  }
  // Under even pressure von Mises is only the round-off of its components.
  const double round_off = 1e-12 * component;
  const double peak = result.peak.field_maximum.value();
  result.self_checks.reported_peak_is_field_maximum =
      std::isfinite(peak) &&
      std::abs(largest - peak) <=
          (1e-9 + strain_round_off<dim>(level.governing->discretization)) *
                  peak +
              round_off;
  if (result.self_checks.reported_peak_is_field_maximum) return component;
  throw Error("F003", "part " + job.part.name,
              fmt::format("reported peak {:.6g} MPa, field maximum {:.6g} MPa",
                          peak / 1e6, largest / 1e6),
              "Please report this scene.");
}

/// Under even pressure von Mises is the round-off of K u and settles nowhere.
/// @param component  largest stress component [Pa].
void settle_even_pressure(double component, PeakStress& peak) {
  constexpr double kRoundOff = 1e-7;
  const double bound = kRoundOff * component;
  if (peak.value > bound || peak.verdict == PeakVerdict::kConverged) return;
  peak.verdict = PeakVerdict::kConverged;
  peak.band_low = 0.0;
  peak.band_high = bound;
}

template <int dim>
PartFields make_fields(const PartJob& job, const Level<dim>& level) {
  PartFields fields;
  fields.dim = dim;
  fields.shape = level.governing->discretization.shape;
  fields.worst = level.history();
  fields.peak_instant = level.history().peak_instant;
  for (const auto& instant : job.load_sets[level.set].history.instants) {
    fields.times.push_back(instant.time);
  }
  for (std::size_t s = 0; s < level.bases.size(); ++s) {
    const auto& instants = job.load_sets[s].history.instants;
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      fields.history.push_back({s, instants[i].label, instants[i].time,
                                level.histories[s].peak[at],
                                level.bases[s]->strain_energy[at]});
    }
  }
  fields.at = [basis = level.governing, material = job.part.material](
                  int instant, int subdivisions) {
    return stress::instant_field<dim>(*basis, material, subdivisions, instant);
  };
  fields.over = [basis = level.governing, material = job.part.material](
                    const std::vector<stress::FieldPoint>& points,
                    int subdivisions, const std::vector<int>& instants) {
    return stress::point_history<dim>(*basis, material, subdivisions, points,
                                      instants);
  };
  return fields;
}

/// From the last three degrees if their worst instant is the same.
std::optional<double> energy_error(
    const std::vector<SequenceMember>& sequence) {
  std::vector<stress::EnergyValue> values;
  for (const SequenceMember& member : sequence) {
    if (member.label != sequence.back().label)
      values.clear();
    else
      values.push_back({member.dofs, member.strain_energy});
  }
  if (values.size() < 3) return std::nullopt;
  return stress::strain_energy_error(values);
}

/// The last degree's, the last change on both sides; nothing where no plane
/// face holds the part.
std::optional<SupportStress> support_stress(
    const std::vector<std::optional<SupportStress>>& degrees) {
  std::optional<SupportStress> held = degrees.back();
  if (held && degrees.size() > 1) {
    const auto& before = degrees[degrees.size() - 2];
    const double change =
        std::abs(held->value - (before ? before->value : 0.0));
    held->band_low = std::max(0.0, held->band_low - change);
    held->band_high += change;
  }
  return held;
}

template <int dim>
void fill_probes(const PartJob& job, const DegreeLadder<dim>& ladder,
                 std::vector<ProbeResult>& results) {
  std::size_t index = 0;
  for (const auto& load_case : job.part.cases) {
    for (const auto& probe : load_case.probes) {
      const auto band = probe_band(ladder, index++, load_case.name,
                                   probe.quantity, job.tolerance);
      results.push_back(
          {probe.name, probe.quantity, band.value, band.low, band.high});
    }
  }
}

}  // namespace

template <int dim>
PartAssessment assess(const PartJob& job, const FeModel<dim>& model,
                      const DegreeLadder<dim>& ladder,
                      const PartSeconds& seconds) {
  const Level<dim>& level = ladder.level;
  const auto& history = level.history();
  PartAssessment assessment;
  PartResult& result = assessment.result;
  result.seconds = seconds;
  result.peak.sequence = ladder.sequence;
  result.model = fmt::format("{}, p = {}", model.name, level.member.degree);
  result.stopped_because = ladder.ended_by;
  result.engine = elasticity::word_of(level.governing->engine.engine);
  result.engine_why = level.governing->engine.why;
  result.dofs = level.member.dofs;
  result.cells = model.cells_in_plane.value_or(
      static_cast<int>(ladder.zones.mesh().cells.size()));
  for (const auto& basis : level.bases) {
    result.load_columns += static_cast<int>(basis->columns.cols());
  }
  const PeakPlace solved{level.set, history.peak_at, history.peak_instant};
  result.peak.field_maximum = level.history().largest();
  if (ladder.zones.is_singular()) {
    fill_peak<dim>(job, ladder, ladder.band, solved, result.peak);
  } else {
    fill_peak<dim>(job, ladder, ladder.band, place_of(ladder, solved),
                   result.peak);
    fill_nearby<dim>(ladder, result.peak);
  }
  fill_zones<dim>(job, ladder, result);
  result.held = support_stress(ladder.held);
  fill_checks<dim>(level, result.self_checks);
  fill_probes<dim>(job, ladder, result.probes);
  settle_even_pressure(check_reported_peak<dim>(job, level, result),
                       result.peak);
  fill_deflection<dim>(job, ladder, result);
  fill_motion<dim>(job, level, result.finite_motion);
  result.strain_energy_error = energy_error(ladder.sequence);
  assessment.fields = make_fields<dim>(job, level);
  assessment.fields.zones = ladder.zones.marks(level.set);
  if (ladder.nearby) assessment.open_places = ladder.nearby->open;
  if (judged_peak(result).verdict == PeakVerdict::kNotConverged) {
    const auto coarse = ladder.zones.coarse_places();
    assessment.open_places.insert(assessment.open_places.end(), coarse.begin(),
                                  coarse.end());
  }
  return assessment;
}

template PartAssessment assess<2>(const PartJob&, const FeModel<2>&,
                                  const DegreeLadder<2>&, const PartSeconds&);
template PartAssessment assess<3>(const PartJob&, const FeModel<3>&,
                                  const DegreeLadder<3>&, const PartSeconds&);

}  // namespace clevis::assessment
