#include "assessment/impact/impact_check.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "assessment/impact/blow_ladder.h"
#include "assessment/impact/impact_rows.h"
#include "assessment/impact/late_response.h"
#include "assessment/impact/response_scatter.h"
#include "assessment/impact/struck_run.h"
#include "assessment/impact/wave_front_refinement.h"
#include "assessment/judge/model_band.h"
#include "assessment/models/model_list.h"
#include "base/messages/errors.h"
#include "elasticity/vibration/eigenmodes.h"
#include "loads/parts/case_loads.h"

namespace clevis::assessment {
namespace {

using dynamics::Route;

// Blows of a part up to which every one that is not hard is computed by both
// routes.
constexpr std::size_t kCrossChecked = 4;
constexpr double kMostSolves = 2e7;  // some seconds

/// A band about the deflection, what comes later above it.
/// @param error  of the deflection [m].
void take_deflection(double value, double error, ImpactResult& impact) {
  impact.deflection = value;
  impact.deflection_low = std::max(0.0, value - error);
  impact.deflection_high =
      value + error + (impact.later_deflection - 1.0) * value;
}

/// @param space  error of the elements [1].
template <int dim>
void note_deflection(const StruckRun<dim>& best, double space,
                     ImpactResult& impact) {
  impact.deflection_at = best.deflection.at;
  impact.deflection_time = best.response.motion().time[best.deflection.instant];
  take_deflection(
      best.deflection.value,
      best.deflection_sampling +
          (space + best.response.solution.error()) * best.deflection.value,
      impact);
}

/// The held sections' nominal stress of a blow whose degrees are not climbed.
/// @param coarse  of a lower degree.
template <int dim>
std::optional<SupportStress> support_stress(const StruckRun<dim>& best,
                                            const StruckRun<dim>& coarse,
                                            const ImpactResult& impact) {
  const double value = best.root.value;
  if (value == 0.0) return std::nullopt;
  const auto& fronts = impact.refinement;
  const double error =
      std::abs(coarse.root.value / value - 1.0) + best.error_in_time();
  return SupportStress{value,
                       std::max(0.0, value * (1.0 - error - fronts.root_below)),
                       value * (impact.later_root + error + fronts.root_above),
                       best.root.name,
                       best.response.motion().time[best.root.sample],
                       fmt::format("impact {}", impact.name)};
}

template <int dim>
void note_motion(const StruckRun<dim>& best, ImpactResult& impact) {
  const auto& run = best.response.motion();
  impact.peak_force = run.peak_force;
  impact.rise_time = run.peak_force_time;
  impact.load_duration = run.release_time >= 0.0
                             ? run.release_time
                             : run.time[run.time.size() - 1];
  impact.dynamic_factor = best.factor;
  impact.reason = best.response.solution.reason;
}

void take_spread(const ResponseScatter& spread, ImpactResult& impact) {
  impact.spread = spread.largest;
  widen(spread.stress_low, spread.stress_high, impact.band_low,
        impact.band_high);
  if (impact.root) {
    widen(spread.root_low, spread.root_high, impact.root->band_low,
          impact.root->band_high);
  }
  widen(spread.deflection_low, spread.deflection_high, impact.deflection_low,
        impact.deflection_high);
}

struct Computed {
  ImpactResult result;
  double force{};      ///< static, that stresses as much [N]
  double stiffness{};  ///< of the struck face [N/m]
  BlowTimes times;
};

/// Unknowns times steps that all equations would take.
template <int dim>
double solves_of(const StruckRun<dim>& run) {
  return double(run.response.basis.equations) * run.response.solution.steps;
}

/// Whether a duration that was given ends while the striker presses and the
/// worst may be to come.
bool ends_too_soon(const loads::Strike& strike,
                   const dynamics::StrikeRun& run) {
  constexpr double kLate = 0.9;
  if (!strike.duration || run.release_time >= 0.0) return false;
  const double late = kLate * *strike.duration;
  return strike.force == 0.0 || run.peak_contact_time > late ||
         run.peak_force_time > late;
}

/// The blow for as long as its peaks need, where no duration is given and its
/// course can be told.
/// @param run  of the default or given duration; becomes that of the blow.
template <int dim>
ImpactJob lengthened(const PartJob& job, const ImpactJob& given,
                     const std::vector<stress::SingularZone>& zones, int degree,
                     StruckFaces<dim>& faces, StruckRun<dim>& run,
                     ImpactResult& result) {
  constexpr double kTold = 0.05;
  const auto later =
      late_response(job, given, zones, degree, run, result.first_period, faces);
  result.looked_for = later.looked_for;
  ImpactJob impact = given;
  std::size_t last = 0;
  for (std::size_t i = 1; i < later.spans.size(); ++i) {
    ImpactJob longer = given;
    longer.strike.duration = later.spans[i].duration;
    longer.samples = given.samples << i;
    auto more = run_struck(job, longer, zones, degree, Route::kAuto, faces);
    if (more.response.solution.error() > kTold) break;
    run = std::move(more);
    impact = longer;
    last = i;
  }
  result.later_stress = later.spans[last].stress;
  result.later_deflection = later.spans[last].deflection;
  result.later_root = later.spans[last].root;
  result.free_vibration_stress = later.free_vibration_stress;
  result.free_vibration_deflection = later.free_vibration_deflection;
  return impact;
}

template <int dim>
Computed compute(const PartJob& job, const ImpactJob& given,
                 StruckFaces<dim>& faces) {
  const bool simplex = job.mesh.shape == mesh::CellShape::kSimplex;
  const int low = simplex ? 1 : 2, high = low + 1;
  const auto zones =
      stress::singular_zones<dim>(faces.mesh(), job.part.material, given.fixed);
  Computed found;
  ImpactResult& result = found.result;
  const auto unit = loads::case_loads(job.part, static_case(job, given, 1.0),
                                      job.groups, job.mass);
  result.first_period = elasticity::period_along<dim>(
      {faces.mesh(), job.part.material, unit, given.fixed, job.part.name}, low,
      given.strike.direction);
  const double front =
      shortest_wave_front(faces.mesh(), job.part.material, high);
  ImpactJob impact = given;
  impact.front = 2.0 * front;
  StruckRun<dim> coarse =
      run_struck(job, impact, zones, low, Route::kAuto, faces);
  impact = lengthened(job, impact, zones, low, faces, coarse, result);
  impact.front = front;
  std::optional<StruckRun<dim>> direct;
  const bool is_long = solves_of(coarse) > kMostSolves;
  if (job.impacts.size() <= kCrossChecked && !is_hard(coarse) && !is_long &&
      job.part.damping == 0.0) {
    direct = run_struck(job, impact, zones, low, Route::kDirect, faces);
  }
  const StruckRun<dim> fine =
      run_struck(job, impact, zones, high, Route::kAuto, faces);
  double same_front = fine.stress;  // as that of `coarse`
  if (has_short_wave_fronts(fine)) {
    result.refinement =
        refine_wave_front(job, impact, zones, high, fine, faces);
    same_front = result.refinement.stress[1];
  }
  result.name = impact.strike.name;
  result.source = impact.source;
  result.mass = impact.strike.mass;
  result.speed = impact.strike.speed;
  result.force = impact.strike.force;
  result.stiffness = fine.response.solution.contact_stiffness;
  result.is_ideal = fine.response.solution.is_ideal;
  result.exponent = impact.strike.contact.exponent;
  result.part_mass = fine.response.mass;
  note_motion(fine, result);
  if (is_long) result.reason += ", and is left out as a check";
  note_deflection(
      fine, std::abs(coarse.deflection.value / fine.deflection.value - 1.0),
      result);
  result.is_cut = ends_too_soon(given.strike, fine.response.motion());
  const double stiffness = fine.response.stiffness;
  const double force = equivalent_force(impact.strike, stiffness);
  found.force = fine.factor * force;

  const auto bar = bar_of(job, impact);
  result.is_axial = bar && bar->is_rod;
  if (bar) {
    add_beam_rows(*bar, impact.strike, result.rows);
    result.beam_factor = beam_factor(*bar, impact.strike);
  }
  result.root = support_stress(fine, coarse, result);
  const std::optional<ResponseScatter> spread =
      response_scatter(job, impact, zones, low, coarse, fine, faces);
  const double space =
      std::abs(coarse.factor / fine.factor * fine.stress / same_front - 1.0);
  std::optional<double> nominal;
  if (fine.static_root > 0.0) nominal = force * fine.static_root;
  result.rows.push_back(
      {.model = ImpactModel::kStaticTimesFactor,
       .degree = high,
       .stress = force * fine.static_stress,
       .nominal = nominal,
       .face = force / stiffness,
       .deflection = force * fine.static_deflection,
       .error = std::abs(coarse.static_stress / fine.static_stress - 1.0),
       .seconds = fine.static_seconds});
  const double coarse_error = std::abs(coarse.stress / fine.stress - 1.0);
  if (direct) {
    result.rows.push_back(
        struck_row(*direct, low, coarse_error + direct->error_in_time()));
  }
  result.rows.push_back(
      struck_row(coarse, low, coarse_error + coarse.error_in_time()));
  const double error = space + fine.error_in_time();
  const auto& fronts = result.refinement;
  result.rows.push_back(
      struck_row(fine, high, error + std::max(fronts.below, fronts.above)));
  result.stress = fine.stress;
  result.band_low = fine.stress * (1.0 - error - fronts.below);
  result.band_high = fine.stress * (1.0 + error + fronts.above);
  if (spread) take_spread(*spread, result);
  found.stiffness = stiffness;
  found.times = {.time = fine.response.motion().time,
                 .candidates = fine.candidates,
                 .error = fine.error_in_time(),
                 .front = front,
                 .below = fronts.below,
                 .above = fronts.above,
                 .root_below = fronts.root_below,
                 .root_above = fronts.root_above,
                 .later = result.later_stress,
                 .root_later = result.later_root,
                 .spread = spread};
  return found;
}

/// @throws Error F005 if the job asks for a model without an answer in time.
void require_answer_in_time(const PartJob& job) {
  if (!job.model || traits_of(*job.model).answers_in_time) return;
  std::vector<std::string_view> names;
  for (const ModelTraits& model : kModels) {
    if (model.answers_in_time) names.push_back(model.name);
  }
  throw Error("F005", fmt::format("part {}", job.part.name),
              fmt::format("a blow is computed by {}", fmt::join(names, " or ")),
              "Leave --model out.");
}

/// The blows by the cheapest model in time that suits each; what blows on one
/// face share is kept.
class BlowModels {
 private:
  PartJob at_rest(const ImpactJob& impact, double force) const {
    PartJob rest = job_;
    const auto load_case = static_case(job_, impact, force);
    rest.load_sets = {
        {loads::case_loads(job_.part, load_case, job_.groups, job_.mass),
         impact.fixed}};
    return rest;
  }

  /// Applies `use` to the model of a blow and the faces of its mesh.
  template <class Use>
  auto by_model(const ImpactJob& impact, Use use) {
    const PartJob rest = at_rest(impact, 1.0);
    const PartShape shape(rest);
    const Model& entry = cheapest_in_time(shape);
    return std::visit(
        [&]<int dim>(FeModel<dim> model) {
          if constexpr (dim == 3) {
            return use(entry, std::move(model), solid_);
          } else {
            StruckFaces<dim> faces(*model.mesh);
            return use(entry, std::move(model), faces);
          }
        },
        entry.make(shape, {}));
  }

 public:
  explicit BlowModels(const PartJob& job) : job_(job), solid_(job.mesh) {
    require_answer_in_time(job);
    for (const ImpactJob& impact : job.impacts) {
      blows_.push_back(
          by_model(impact, [&]<int dim>(const Model&, const FeModel<dim>&,
                                        StruckFaces<dim>& faces) {
            return compute<dim>(job_, impact, faces);
          }));
    }
  }

  std::vector<Computed>& blows() { return blows_; }

  PartAssessment climb(std::size_t index) {
    const ImpactJob& impact = job_.impacts[index];
    const Computed& blow = blows_[index];
    return by_model(impact, [&]<int dim>(const Model& entry, FeModel<dim> model,
                                         StruckFaces<dim>& faces) {
      const PartJob rest = at_rest(impact, blow.force);
      model.model_error = entry.error(PartShape(rest));
      return climb_blow<dim>(job_, impact, blow.times, model, faces);
    });
  }

  LoadSet load_at_rest(std::size_t index) const {
    return at_rest(job_.impacts[index], blows_[index].force).load_sets[0];
  }

 private:
  const PartJob& job_;
  StruckFaces<3> solid_;
  std::vector<Computed> blows_;
};

/// Puts what the climbed degrees say in place of the last run's.
void take_assessment(const PartAssessment& climbed, ImpactResult& impact) {
  const PartResult& part = climbed.result;
  const PeakStress& judged = judged_peak(part);
  ImpactRow& row = impact.rows.back();
  impact.stress = judged.value;
  row.stress = judged.value;
  impact.band_low = judged.band_low;
  impact.band_high = judged.band_high;
  row.error = std::max(judged.band_high - judged.value,
                       judged.value - judged.band_low) /
              judged.value;
  row.degree = part.peak.sequence.back().degree;
  row.seconds = part.seconds.assemble + part.seconds.factor +
                part.seconds.solve + part.seconds.recover;
  const double low = impact.deflection_low, high = impact.deflection_high;
  take_deflection(part.deflection,
                  std::max(impact.deflection - impact.deflection_low,
                           std::abs(part.deflection - impact.deflection)),
                  impact);
  if (impact.spread > 0.0) {
    widen(low, high, impact.deflection_low, impact.deflection_high);
  }
  row.deflection = part.deflection;
  impact.root = part.held;
  row.nominal.reset();
  if (part.held) row.nominal = part.held->value;
  impact.deflection_at = part.deflection_at;
  impact.deflection_time = part.deflection_instant;
}

/// The models beside the judged one, the last.
/// @param stiffness  of the struck face [N/m].
void compare_rows(double stiffness, ImpactResult& impact) {
  const ImpactRow judged = impact.rows.back();
  // beam theory's rows know the root's section alone
  const bool by_section =
      judged.nominal && std::ranges::any_of(impact.rows, [](auto& row) {
        return !row.stress;
      });
  const auto stress = by_section ? &ImpactRow::nominal : &ImpactRow::stress;
  for (ImpactRow& row : impact.rows) {
    if (row.*stress) row.ratio = *(row.*stress) / (judged.*stress).value();
    row.remark = remark_on(row, impact, judged.face, stiffness);
  }
  impact.rows.back().remark = "judged";
}

/// Whether another blow may stress or deflect the part more, so that this one
/// is told by its own two degrees.
bool is_outdone(const ImpactResult& blow, const std::vector<Computed>& all) {
  constexpr double kClearly = 0.9;
  return std::ranges::any_of(all, [&](const Computed& other) {
    return blow.band_high < kClearly * other.result.band_low &&
           blow.deflection < kClearly * other.result.deflection;
  });
}

}  // namespace

CheckedBlows check_blows(const PartJob& job) {
  CheckedBlows found;
  if (job.impacts.empty()) return found;
  BlowModels models(job);
  for (std::size_t i = 0; i < models.blows().size(); ++i) {
    found.at_rest.push_back(models.load_at_rest(i));
    ImpactResult impact = models.blows()[i].result;
    if (!is_outdone(impact, models.blows())) {
      PartAssessment climbed = models.climb(i);
      for (InstantRow& row : climbed.fields.history) row.load_set.reset();
      take_assessment(climbed, impact);
      climbed.result.deflection_low = impact.deflection_low;
      climbed.result.deflection_high = impact.deflection_high;
      found.assessment = found.assessment ? join(std::move(*found.assessment),
                                                 std::move(climbed))
                                          : std::move(climbed);
    }
    compare_rows(models.blows()[i].stiffness, impact);
    const double hidden = job.part.limits.exclude_singular_zones && impact.root
                              ? impact.root->value
                              : 0.0;
    impact.safety_factor =
        job.part.material.yield_strength / std::max(impact.stress, hidden);
    found.impacts.push_back(std::move(impact));
  }
  for (const ImpactResult& impact : found.impacts) {
    auto& held = found.assessment->result.held;
    held = larger(held, impact.root);
  }
  return found;
}

void add_blows_at_rest(PartJob& job) {
  if (job.impacts.empty()) return;
  const PartJob given = job;
  BlowModels models(given);
  for (std::size_t i = 0; i < models.blows().size(); ++i) {
    job.load_sets.push_back(models.load_at_rest(i));
  }
}

void finish_impacts(std::vector<ImpactResult> impacts, PartResult& result) {
  const bool unsettled =
      std::ranges::any_of(impacts, [](const ImpactResult& i) {
        return !i.refinement.settles || i.is_cut;
      });
  for (PeakStress* peak : each_peak(result)) {
    if (!unsettled) continue;
    peak->has_band = false;
    if (peak->verdict == PeakVerdict::kConverged) {
      peak->verdict = PeakVerdict::kNotConverged;
    }
  }
  if (!impacts.empty()) result.first_period = impacts.front().first_period;
  result.impacts = std::move(impacts);
}

}  // namespace clevis::assessment
