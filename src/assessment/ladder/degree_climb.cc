#include "assessment/ladder/degree_climb.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "assessment/judge/time_sampling_error.h"
#include "assessment/ladder/governing_instants.h"
#include "assessment/ladder/load_accuracy.h"
#include "assessment/ladder/probe_band.h"
#include "assessment/places/local_error.h"
#include "assessment/places/meeting_places.h"
#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "stress/corners/round_depth.h"
#include "stress/peaks/peak_zoom.h"
#include "stress/surface/surface_deviation.h"

namespace clevis::assessment {
namespace {

using stress::Convergence;

/// Widens a band upwards by the error of sampling.
stress::Band widened(stress::Band band, double sampling_error,
                     double tolerance) {
  band.high += sampling_error;
  if (band.verdict == Convergence::kConverged &&
      band.high - band.value > tolerance * band.value) {
    band.verdict = Convergence::kNotConverged;
  }
  return band;
}

stress::Band band_of(const std::vector<SequenceMember>& sequence,
                     double sampling_error, double tolerance,
                     double share_of_change_before) {
  std::vector<stress::SequenceValue> values;
  for (const auto& member : sequence) {
    values.push_back({member.degree, member.peak});
  }
  return widened(stress::peak_band(values, tolerance, share_of_change_before),
                 sampling_error, tolerance);
}

template <int dim>
stress::Band outer_band_of(const ZoneTracker<dim>& zones, double tolerance,
                           double share_of_change_before) {
  std::vector<SequenceMember> sequence;
  for (const auto& peak : zones.outside()) sequence.push_back(peak.member);
  const OutsidePeak& last = zones.outside().back();
  return band_of(sequence, last.sampling_error + last.time_error, tolerance,
                 share_of_change_before);
}

/// One climb.
template <int dim>
class Climb {
 public:
  Climb(const PartJob& job, const FeModel<dim>& model, PartSeconds& seconds)
      : job_(job),
        model_(model),
        seconds_(seconds),
        ladder_(job, *model.mesh) {}

  /// Adds a degree, solved for these sets.
  /// @param admitted  errors of their loads, if any.
  void take(const std::vector<LoadSet>& sets, int degree,
            const std::vector<Eigen::VectorXd>& admitted = {}) {
    const auto solve = [&](const std::vector<Eigen::VectorXd>& errors) {
      return solve_level<dim>(job_, sets, ladder_.zones.mesh(), model_, degree,
                              seconds_, errors);
    };
    ladder_.level = solve(admitted);
    if (peak_is_inexact<dim>(ladder_.level)) ladder_.level = solve({});
    ladder_.sequence.push_back(ladder_.level.member);
    ladder_.probes.push_back(ladder_.level.probes);
    ladder_.held.push_back(ladder_.level.held);
    ladder_.deflections.take(sets, ladder_.level);
    ladder_.zones.take(ladder_.level);
    const double tolerance = job_.tolerance - model_.model_error;
    const auto& history = ladder_.level.history();
    ladder_.time_error =
        time_sampling_error(sets[ladder_.level.set].history, history.peak) +
        rise_of_inexact<dim>(ladder_.level);
    ladder_.band =
        band_of(ladder_.sequence, history.sampling_error + ladder_.time_error,
                tolerance, model_.share_of_change_before);
    if (ladder_.zones.is_singular()) {
      ladder_.time_error = ladder_.zones.outside().back().time_error;
      ladder_.outer_band = outer_band_of(ladder_.zones, tolerance,
                                         model_.share_of_change_before);
    }
    if (ladder_.level.member.peak <= 0.0) return;
    if (two_may_do()) {
      look_after_two(sets, tolerance);
      return;
    }
    if (ladder_.sequence.size() < kDegreesOfABand) return;
    if (model_.looks_at_places) {
      look_at_places(sets, tolerance,
                     degree < model_.highest_degree
                         ? PlaceSearch::kWhileItMayConverge
                         : PlaceSearch::kAll);
    } else if (ladder_.zones.is_singular() || !model_.looks_nearby ||
               !look_nearby(sets, tolerance)) {
      join_cells(tolerance);
    }
    if (ladder_.zones.is_singular()) widen_beside_zones(tolerance);
  }
  /// Adds a degree if memory and --max-dofs admit it, else says what did not.
  /// @return whether they do.
  /// @throws Error F004, F007 if there is no result without it: three degrees
  ///   have a band; fewer are asked for by --max-dofs alone, and not judged.
  bool may_take(const std::vector<LoadSet>& sets, int degree,
                const std::vector<Eigen::VectorXd>& admitted = {}) {
    try {
      take(sets, degree, admitted);
    } catch (const Error& error) {
      const std::size_t taken = ladder_.sequence.size();
      const bool is_end =
          (error.code() == "F004" && taken >= kDegreesOfABand) ||
          (error.code() == "F007" && taken > 0);
      if (!is_end) throw;
      ladder_.ended_by =
          fmt::format("degree {} left out, {}", degree, error.problem());
      return false;
    }
    return true;
  }
  /// The degree that was taken last is the last: all its places count.
  void end(const std::vector<LoadSet>& sets) {
    // One degree alone does not tell what comes from outside of a place.
    constexpr std::size_t kFewest = 2;
    const double tolerance = job_.tolerance - model_.model_error;
    if (!model_.looks_at_places || is_within() ||
        ladder_.sequence.size() < kFewest) {
      return;
    }
    look_at_places(sets, tolerance, PlaceSearch::kAll);
    if (ladder_.zones.is_singular()) widen_beside_zones(tolerance);
  }
  /// Whether what no degree mends keeps the peak's band from the tolerance, and
  /// nothing else asks for a higher degree.
  bool is_in_vain() const {
    constexpr double kSure = 1.1;  // the value is not known yet
    return ladder_.sequence.size() >= kDegreesOfABand && lasting_error_ > 0.0 &&
           lasting_error_ > kSure * (job_.tolerance - model_.model_error) &&
           !deflection_is_open() &&
           probes_are_within(ladder_, job_, job_.tolerance);
  }
  /// Says why the degrees end before the highest.
  void tell_in_vain() {
    const auto& last = ladder_.sequence.back();
    if (last.degree >= model_.highest_degree) return;
    ladder_.ended_by = fmt::format(
        "degree {} left out, finer cells are wanted: the faces of these are "
        "off the curved surface by {:.2g} % of the stress",
        last.degree + 1, 100.0 * lasting_error_);
  }
  void drop() {
    ladder_.sequence.pop_back();
    ladder_.probes.pop_back();
    ladder_.held.pop_back();
    ladder_.deflections.drop();
  }
  bool is_within() const {
    const auto& judged =
        ladder_.zones.is_singular() ? ladder_.outer_band : ladder_.band;
    if (judged.verdict != Convergence::kConverged) return false;
    if (ladder_.sequence.size() < kDegreesOfABand) {
      return ladder_.two_are_enough;
    }
    return probes_are_within(ladder_, job_, job_.tolerance);
  }
  /// Whether the next degree may be the last: a band is a share of the change
  /// before the last at least (stress::peak_band).
  bool may_settle() const {
    const auto& sequence = ladder_.sequence;
    if (sequence.size() < 2) return false;
    const double last = sequence.back().peak;
    const double change = last - std::prev(sequence.end(), 2)->peak;
    return model_.share_of_change_before * std::abs(change) <=
           job_.tolerance * last;
  }
  const DegreeLadder<dim>& ladder() const { return ladder_; }
  DegreeLadder<dim> finish() { return std::move(ladder_); }

 private:
  static constexpr std::size_t kDegreesOfABand = 3;

  /// Whether two degrees and finer solutions near the peak may be enough: for a
  /// wide tolerance, where nothing but the peak is asked for.
  bool two_may_do() const {
    constexpr double kSoft = 0.4;  // Poisson's ratio, from where degree 2 locks
    return model_.looks_at_places && ladder_.sequence.size() == 2 &&
           job_.tolerance - model_.model_error >= kWideTolerance &&
           job_.part.material.poissons_ratio <= kSoft &&
           !ladder_.zones.has_zones() && !job_.part.limits.deflection &&
           // Energies of one instant tell what is still to come.
           ladder_.sequence.front().label == ladder_.sequence.back().label &&
           std::ranges::all_of(job_.part.cases, [](const auto& load_case) {
             return load_case.probes.empty();
           });
  }

  /// Keeps what finer solutions near the peak found only if it is enough.
  void look_after_two(const std::vector<LoadSet>& sets, double tolerance) {
    const stress::Band of_two = ladder_.band;
    look_at_places(sets, tolerance, PlaceSearch::kWhileItMayConverge);
    ladder_.two_are_enough =
        ladder_.band.verdict == Convergence::kConverged && !is_beside_hollow();
    if (ladder_.two_are_enough) return;
    ladder_.band = of_two;
    ladder_.nearby.reset();
  }

  /// Whether the peak stands in cells so deep beside a hollow face that more
  /// degrees than two tell by their changes what they hide.
  bool is_beside_hollow() const {
    if constexpr (dim == 3) {
      const NearbyPeak& peak = *ladder_.nearby;
      const Eigen::Vector3d at = stress::position<dim>(
          ladder_.level.bases[peak.set]->discretization, peak.at,
          ladder_.level.histories[peak.set].subdivisions);
      return stress::depth_over_radius(ladder_.zones.mesh(), at) >
             stress::kResolvedDepth;
    }
    return false;
  }

  /// Whether the limit of the deflection lies in its band.
  bool deflection_is_open() const {
    const auto limit = job_.part.limits.deflection;
    if (!limit) return false;
    const DeflectionBand band = ladder_.deflections.band();
    return band.low <= *limit && *limit < band.high;
  }

  /// Cells that are many times as large as a zone do not show what stands
  /// beside it.
  void widen_beside_zones(double tolerance) {
    stress::Band& band = ladder_.outer_band;
    const double missing =
        (ladder_.zones.unresolved_growth() - 1.0) * band.value -
        (band.high - band.value);
    band = widened(band, std::max(0.0, missing), tolerance);
  }

  /// Puts the band of the peak's neighbourhood in place of the sequence's.
  /// @return whether there is one.
  bool look_nearby(const std::vector<LoadSet>& sets, double tolerance) {
    Stopwatch watch;
    const auto& sequence = ladder_.sequence;
    const auto values =
        local_peak<dim>(job_, sets, ladder_.zones.mesh(), ladder_.level,
                        sequence[sequence.size() - 2].field_peak.value());
    seconds_.recover += watch.lap();
    if (!values) return false;
    stress::Band band = stress::local_band(*values, tolerance);
    band.value = sequence.back().peak;
    band.low = std::min(band.low, band.value);
    ladder_.band = widened(band, ladder_.time_error, tolerance);
    return true;
  }

  /// The sequence may come to rest by chance: a peak, which is by one cell
  /// alone, is in doubt by what its neighbours say as well.
  void join_cells(double tolerance) {
    const bool is_outer = ladder_.zones.is_singular();
    stress::Band& judged = is_outer ? ladder_.outer_band : ladder_.band;
    const auto cells = cell_agreement<dim>(
        ladder_.level,
        is_outer ? ladder_.zones.outside_histories() : ladder_.level.histories);
    ladder_.jump = cells.jump;
    const double doubt = kErrorOfJump * cells.jump;
    judged.low = std::min(judged.low - doubt, cells.mean);
    judged.high += doubt;
    if (!is_outer) judged.high += above_lattice();
    const double reach =
        std::max(judged.high - judged.value, judged.value - judged.low);
    if (judged.verdict == Convergence::kConverged &&
        reach > tolerance * judged.value) {
      judged.verdict = Convergence::kNotConverged;
    }
  }

  /// Rise of the field between the points of the lattice [Pa]: bending has its
  /// peak beside the face of a plate, not on it.
  double above_lattice() const {
    const auto& history = ladder_.level.history();
    return stress::field_maximum<dim>(*ladder_.level.governing,
                                      job_.part.material, history) -
           history.largest();
  }

  /// Share of a peak that may come from outside of its neighbourhood [1]: a
  /// share of what the strain energy of the same instant, or else the peak,
  /// still changes by, and the energy between faces and curved surfaces.
  double pollution() { return change_of_degree() + beside_surfaces(); }

  /// Share of a peak that the last degree's change elsewhere may bring [1].
  double change_of_degree() const {
    constexpr double kShareOfEnergy = 0.1;
    constexpr double kShareOfPeak = 0.01;
    constexpr double kMuch = 0.03;
    const SequenceMember& last = ladder_.sequence.back();
    const SequenceMember& before = *std::prev(ladder_.sequence.end(), 2);
    if (last.label != before.label) {
      return kShareOfPeak * std::abs(1.0 - before.peak / last.peak);
    }
    const double change =
        std::abs(1.0 - before.strain_energy / last.strain_energy);
    const double share = kShareOfEnergy * change;
    return change > kMuch ? std::max(share, energy_to_come(change)) : share;
  }

  /// What a geometric series of the strain energy's changes would still bring,
  /// over the last energy [1]: thin curved walls that lock are too stiff as a
  /// whole, and their stress is too low by as much. After two degrees the
  /// change itself stands for the ratio.
  /// @param change  of the last degree [1].
  double energy_to_come(double change) const {
    constexpr double kSlowest = 0.8;
    double ratio = change;
    if (ladder_.sequence.size() > 2) {
      const SequenceMember& last = ladder_.sequence.back();
      const SequenceMember& before = *std::prev(ladder_.sequence.end(), 2);
      const SequenceMember& first = *std::prev(ladder_.sequence.end(), 3);
      if (first.label == last.label) {
        ratio = change * last.strain_energy /
                std::abs(before.strain_energy - first.strain_energy);
      }
    }
    ratio = std::min(ratio, kSlowest);
    return change * ratio / (1.0 - ratio);
  }

  /// Share of a peak that faces beside curved surfaces may bring [1]: a disc's
  /// hub changed by three times the energy's share when its fillet's faces, one
  /// wall away, moved onto their surface.
  double beside_surfaces() {
    constexpr double kOfEnergy = 3.0;
    if constexpr (dim == 3) {
      const auto& mesh = ladder_.zones.mesh();
      if (deviation_.empty()) deviation_ = stress::surface_deviation(mesh);
      return kOfEnergy * stress::energy_between(mesh, deviation_,
                                                ladder_.level.history().worst);
    }
    return 0.0;
  }

  /// Puts the band of all places that the peak may stand at in the place of the
  /// sequence's.
  void look_at_places(const std::vector<LoadSet>& sets, double tolerance,
                      PlaceSearch which) {
    Stopwatch watch;
    job_.tell(fmt::format("after degree {}, finer solutions near the peak",
                          ladder_.sequence.back().degree));
    const bool is_outer = ladder_.zones.is_singular();
    auto found = nearby_peak<dim>(
        job_, sets, ladder_.zones.mesh(), ladder_.level,
        is_outer ? ladder_.zones.outside_histories() : ladder_.level.histories,
        pollution(), tolerance, which);
    ladder_.nearby = std::move(found.peak);
    lasting_error_ = found.lasting_error;
    seconds_.recover += watch.lap();
    stress::Band& judged = is_outer ? ladder_.outer_band : ladder_.band;
    if (!ladder_.nearby) {
      if (which == PlaceSearch::kAll) join_cells(tolerance);
      judged.verdict = Convergence::kNotConverged;
      return;
    }
    ladder_.jump = ladder_.nearby->jump;
    judged = widened(
        ladder_.nearby->band,
        ladder_.time_error +
            (is_outer ? ladder_.zones.outside().back().sampling_error : 0.0),
        tolerance);
  }

  const PartJob& job_;
  const FeModel<dim>& model_;
  PartSeconds& seconds_;
  DegreeLadder<dim> ladder_;
  std::vector<double> deviation_;  ///< of faces from curved surfaces [m]
  double lasting_error_{};         ///< of FoundPeak
};

template <int dim>
DegreeLadder<dim> climb_with_all(const PartJob& job, const FeModel<dim>& model,
                                 PartSeconds& seconds) {
  Climb<dim> climb(job, model, seconds);
  std::vector<Eigen::VectorXd> admitted;
  for (int degree = model.first_degree; degree <= model.highest_degree;
       ++degree) {
    if (degree > model.first_degree && !climb.ladder().zones.has_zones()) {
      admitted = admitted_load_errors<dim>(job, climb.ladder().level);
    }
    if (!climb.may_take(job.load_sets, degree, admitted)) {
      climb.end(job.load_sets);
      break;
    }
    if (climb.is_within()) break;
    if (climb.is_in_vain()) {
      climb.end(job.load_sets);
      climb.tell_in_vain();
      break;
    }
  }
  return climb.finish();
}

/// The first degrees solved for the governing instants alone. Nothing where
/// they do not hold the peak, or all are needed.
template <int dim>
std::optional<DegreeLadder<dim>> climb_with_few(
    const PartJob& job, const FeModel<dim>& model,
    const std::vector<LoadSet>& governing, PartSeconds& seconds) {
  // From the third degree on any may be the last: solved for all at once, but
  // for the third where it cannot be.
  constexpr int kFirstDegrees = 3;
  const GoverningInstants chosen(job, governing);
  Climb<dim> climb(job, model, seconds);
  if (chosen.sets().empty() || climb.ladder().zones.has_zones()) {
    return std::nullopt;
  }
  const auto admitted = admitted_load_errors(job, chosen);
  bool is_of_all = false;  // the degree that was taken last
  for (int degree = model.first_degree; degree <= model.highest_degree;
       ++degree) {
    bool all = degree >= model.first_degree + kFirstDegrees ||
               (degree == model.first_degree + kFirstDegrees - 1 &&
                climb.may_settle());
    const bool is_taken = all ? climb.may_take(job.load_sets, degree, admitted)
                              : climb.may_take(chosen.sets(), degree);
    if (is_taken ? !all && (climb.is_within() || climb.is_in_vain() ||
                            degree == model.highest_degree)
                 : !is_of_all) {
      climb.drop();
      climb.take(job.load_sets, is_taken ? degree : degree - 1, admitted);
      all = true;
    }
    if (!all) continue;
    is_of_all = true;
    const Level<dim>& level = climb.ladder().level;
    if (!chosen.contains(level.set, level.history().peak_instant)) {
      return std::nullopt;
    }
    const bool is_last = !is_taken || climb.is_in_vain();
    if (is_last) climb.end(job.load_sets);
    if (is_taken && is_last) climb.tell_in_vain();
    if (is_last || climb.is_within()) break;
  }
  return climb.finish();
}

}  // namespace

template <int dim>
DegreeLadder<dim> climb_degrees(const PartJob& job, const FeModel<dim>& model,
                                const std::vector<LoadSet>& governing,
                                PartSeconds& seconds) {
  auto ladder = climb_with_few(job, model, governing, seconds);
  if (ladder) return std::move(*ladder);
  return climb_with_all(job, model, seconds);  // what few took is free again
}

template DegreeLadder<2> climb_degrees<2>(const PartJob&, const FeModel<2>&,
                                          const std::vector<LoadSet>&,
                                          PartSeconds&);
template DegreeLadder<3> climb_degrees<3>(const PartJob&, const FeModel<3>&,
                                          const std::vector<LoadSet>&,
                                          PartSeconds&);

}  // namespace clevis::assessment
