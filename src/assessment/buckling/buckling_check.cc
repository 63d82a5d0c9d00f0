#include "assessment/buckling/buckling_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "assessment/buckling/buckling_model.h"
#include "assessment/buckling/part_holds.h"
#include "assessment/ladder/degree_climb.h"
#include "assessment/sharing/sharing_check.h"
#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "elasticity/buckling/buckling.h"
#include "loads/history/motion_instants.h"
#include "loads/holds/holding_groups.h"
#include "part/buckling_limit.h"

namespace clevis::assessment {
namespace {

using elasticity::BucklingMode;
using elasticity::Discretization;

constexpr int kFirstDegree = 2;
constexpr int kHighestDegree = 4;

/// Of the first degree alone, where the memory holds no other: on cells that
/// are not long it has less than three times the factor.
constexpr double kThrice = 3.0;

/// Loads that may buckle the part.
struct Candidate {
  std::size_t set{};
  loads::LoadHistory history;
  std::vector<elasticity::HoldingSeats> holds;
  bool is_motion = false;
  std::optional<elasticity::NodalField<3>> known = {};  ///< by the last degree
  double factor{};                                      ///< likewise
  double stiffening{};  ///< of BucklingMode, over all instants
  BucklingMode::OnSprings on_springs = {};  ///< likewise
  Standing standing = {};
};

/// A hold where its slides are at an instant.
elasticity::HoldingSeats of_instant(elasticity::HoldingSeats hold,
                                    const loads::InstantLoad& instant) {
  if (hold.touched) hold.touched->zones = instant.zones;
  hold.instants.clear();
  return hold;
}

/// The lowest factor of candidates, which are left with the instant, the hold
/// and the shape that govern each.
struct Found {
  BucklingMode mode;
  std::string label;
  double instant{};
};
Found lowest(const PartJob& job, const PartSpace& space, double highest,
             BucklingModel& model, std::vector<Candidate>& candidates) {
  std::optional<Found> best;
  for (Candidate& candidate : candidates) {
    const LoadSet& set = job.load_sets[candidate.set];
    elasticity::BucklingProblem problem{
        .discretization = space.whole,
        .material = job.part.material,
        .history = candidate.history,
        .fixed = model.supports(set),
        .holds = candidate.holds,
        .name = job.part.name,
        .foundations = set.foundations,
        .plane = space.plane ? &*space.plane : nullptr,
        .known = candidate.known ? &*candidate.known : nullptr,
        .mass = &job.mass,
        .highest = highest,
        .enough = enough_buckling(job.part.limits)};
    model.factor(set, problem);
    auto mode = elasticity::lowest_buckling(problem);
    const auto& last = candidate.history.instants.back();
    candidate.standing.take({mode.position, last.label, last.time});
    const auto instant =
        candidate.history.instants[static_cast<std::size_t>(mode.instant)];
    candidate.history.instants = {instant};
    candidate.holds = {of_instant(candidate.holds[mode.hold], instant)};
    if (mode.shape.size() > 0) candidate.known = {space.whole, mode.shape};
    candidate.factor = mode.factor;
    candidate.stiffening = std::max(candidate.stiffening, mode.stiffening);
    if (mode.on_springs.yield() > candidate.on_springs.yield()) {
      candidate.on_springs = mode.on_springs;
    }
    if (best && best->mode.factor <= mode.factor) continue;
    best = {std::move(mode), instant.label, instant.time};
  }
  return std::move(*best);
}

BucklingShape shape_of(const PartJob& job,
                       const Discretization<3>& discretization,
                       const BucklingMode& mode) {
  constexpr double kAmplitude = 1e-3;  // [m]
  constexpr int kSubdivisions = 2;
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = discretization;
  basis.columns = mode.shape;
  basis.coefficients = Eigen::MatrixXd::Constant(1, 1, kAmplitude);
  return {discretization.shape,
          stress::instant_field<3>(basis, job.part.material, kSubdivisions, 0)};
}

/// Factors fall with the degree to that of the model: what is still to come is
/// no more than the last change.
/// @param before  the degree's before; nothing: it is the first.
void set_band(std::optional<double> before, double now,
              BucklingResult& result) {
  constexpr double kAbove = 0.1;  // of the change: the stresses' own error
  const double change =
      before ? std::abs(*before - now) : (1.0 - 1.0 / kThrice) * now;
  result.factor = now;
  result.band_low = std::max(0.0, now - change);
  result.band_high = now + (before ? kAbove * change : 0.0);
}

/// The limit lies outside the band, well beyond it where the band is wide.
/// @pre `result` has a factor.
bool is_decided(const BucklingResult& result, double wanted) {
  constexpr double kNarrow = 0.05, kFar = 2.0;
  const bool narrow =
      result.band_high - result.band_low < kNarrow * *result.factor;
  return result.band_low > kFar * wanted ||
         (narrow && (result.band_low > wanted || result.band_high < wanted));
}

/// Factors of the model beyond are not looked for: 100, or far more than is
/// wanted of loads of which vibration makes more.
/// @param swing  times as much.
double highest_factor(double wanted, double swing) {
  constexpr double kHighest = 100.0, kFar = 3.0;
  const double counts = std::max(kFar * wanted, kFirstOrderIsEnough);
  return std::max(kHighest, counts * swing);
}

/// Takes one degree in.
/// @param before  factor of the degree before.
/// @param highest  of the model; it is looked for as far as the degree may
///   have it too high.
void take(const PartJob& job, BucklingModel& model, int degree,
          std::optional<double> before, double highest,
          std::vector<Candidate>& candidates, BucklingCheck& check) {
  const PartSpace space = model.discretize(degree);
  elasticity::require_dofs(space.whole.dofs(), job.max_dofs,
                           "part " + job.part.name);
  constexpr double kOfLater = 1.1;
  const double too_high = before ? kOfLater : kThrice;
  const bool goes_on = !before && !model.is_compact();
  const Found found = lowest(job, space, goes_on ? highest : too_high * highest,
                             model, candidates);
  check.result.label = found.label;
  check.result.instant = found.instant;
  constexpr double kNone = 1e12;
  check.result.of_motions.assign(job.load_sets.size(), kNone);
  check.stiffening.assign(job.load_sets.size(), 0.0);
  for (const Candidate& candidate : candidates) {
    if (candidate.on_springs.yield() > check.on_springs.yield()) {
      check.on_springs = candidate.on_springs;
    }
    check.standing.take(candidate.standing);
    if (!candidate.is_motion) continue;
    double& least = check.result.of_motions[candidate.set];
    least = std::min(least, candidate.factor);
    double& most = check.stiffening[candidate.set];
    most = std::max(most, candidate.stiffening);
  }
  check.result.model = model.name(degree);
  if (found.mode.is_above) {
    check.shape.reset();
    const double bound = goes_on ? highest / kThrice : highest;
    check.result.factor = bound;
    check.result.band_low = check.result.band_high = bound;
    return;
  }
  check.shape = shape_of(job, space.whole, found.mode);
  if (degree == model.lowest_degree()) {
    check.of_lowest_degree = found.mode.factor;
  }
  set_band(before, found.mode.factor, check.result);
}

/// Whether no mechanism loads the part: factors of parts that are joined are
/// summed, which wants narrow bands.
bool has_cases_alone(const PartJob& job) {
  return std::ranges::all_of(job.load_sets, [](const LoadSet& set) {
    return std::ranges::all_of(set.history.instants,
                               &loads::InstantLoad::is_case);
  });
}

/// Climbs the degrees until the limit is decided, by two at least: of the first
/// thin cells may lock by any factor. Compact ones do not: where no factor is
/// found with them that is enough, looked for so far that the model has none
/// below highest_factor(), and of cases alone a factor with its wide band where
/// the tolerance is wide or the next degree has many unknowns. Nor is a third
/// degree of many solved for: its band holds what is missing.
BucklingCheck climb(const PartJob& job, BucklingModel& model, double swing,
                    std::vector<Candidate> candidates) {
  const double wanted = part::wanted_buckling_factor(job.part.limits);
  BucklingCheck check;
  constexpr int kMany = 300'000;  // a minute and more
  std::optional<double> before;
  for (int degree = kFirstDegree; degree <= kHighestDegree; ++degree) {
    try {
      take(job, model, degree, before, highest_factor(wanted, swing),
           candidates, check);
    } catch (const Error& error) {
      if (!is_bearable(error)) throw;
      if (before) return check;  // its band holds what is missing
      check.result.remark = "not computed: " + error.problem();
      if (error.code() != "M005") return check;
      continue;
    }
    check.result.remark.clear();
    const auto next_is_dear = [&] {
      return degree < kHighestDegree &&
             model.discretize(degree + 1).whole.dofs() > kMany;
    };
    const bool is_enough =
        before || (model.is_compact() &&
                   (!check.shape ||
                    (has_cases_alone(job) &&
                     (job.tolerance >= kWideTolerance || next_is_dear()))));
    if (is_enough && is_decided(check.result, wanted) &&
        is_decided(check.result, swing * wanted)) {
      return check;
    }
    if (before && next_is_dear()) {
      check.result.remark = fmt::format(
          "degree {} left out: more than {} unknowns", degree + 1, kMany);
      return check;
    }
    before = check.result.factor;
  }
  return check;
}

/// The loads as they are checked.
/// @param with_all  as of part_holds().
std::vector<Candidate> checked_loads(const PartJob& job, bool with_all) {
  std::vector<Candidate> candidates;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const LoadSet& set = job.load_sets[s];
    const auto motion =
        static_cast<std::ptrdiff_t>(loads::motion_length(set.history));
    const auto& instants = set.history.instants;
    const bool is_motion = motion > 1;  // of cases alone the first counts
    const auto add = [&](loads::LoadHistory history, bool moves) {
      auto holds = part_holds(set, history, with_all);
      candidates.push_back({s, std::move(history), std::move(holds), moves});
    };
    loads::LoadHistory first = set.history;
    if (is_motion && motion < std::ssize(instants)) {  // cases behind it
      loads::LoadHistory cases = set.history;
      cases.instants.assign(instants.begin() + motion, instants.end());
      add(std::move(cases), false);
      first.instants.resize(static_cast<std::size_t>(motion));
    }
    add(std::move(first), is_motion);
  }
  return candidates;
}

/// The loads of other sharings of what equilibrium leaves open.
std::vector<Candidate> other_sharings(const PartJob& job) {
  std::vector<Candidate> candidates;
  for (const OpenSharing& sharing : job.open_sharings) {
    const LoadSet& set = job.load_sets[sharing.set];
    if (sharing.others.empty()) continue;
    loads::LoadHistory history = sharing.checked;
    history.instants = heaviest_of_others(job, sharing);
    auto holds = part_holds(set, history, job.part.ideal_joints);
    candidates.push_back({sharing.set, std::move(history), std::move(holds)});
  }
  return candidates;
}

/// The fluid in long bores of a part, p A [N]: it presses a bent tube on as an
/// axial load of that size would, and pulls it straight as a dead load.
double fluid_columns(const PartJob& job, const loads::InstantLoad& instant) {
  constexpr double kLong = 2.0, kInside = 0.98;  // of the diameter
  const double across = job.sides()[1];
  double sum = 0.0;
  for (const loads::SurfaceLoad& load : instant.surface_loads) {
    const auto group =
        std::ranges::find(job.groups, load.group, &loads::GroupGeometry::name);
    if (group == job.groups.end() || !group->is_cylinder) continue;
    const part::Bore& bore = group->cylinder;
    const double diameter = 2.0 * bore.radius;
    if (bore.length < kLong * diameter || diameter > kInside * across) continue;
    sum += std::max(0.0, load.pressure) * std::numbers::pi * bore.radius *
           bore.radius;
  }
  return sum;
}

/// Euler's load of the part as a bar of one section: between two pins, or held
/// by supports on one face [N].
double load_of_bar(const PartJob& job, const LoadSet& set) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> inertia(
      job.mass.inertia_LCm, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& moments = inertia.eigenvalues();
  const double length = job.sides()[2];
  // Of the mass along the least of its widths.
  const double square = 0.5 * moments.sum() - moments[2];
  const double free_end = set.fixed.size() == 1 ? 0.25 : 1.0;
  const part::Material& material = job.part.material;
  return free_end * std::numbers::pi * std::numbers::pi *
         material.youngs_modulus * square /
         (material.density * length * length * length);
}

/// Lowers the band to `low`. Of a factor that is a bound that is the bound
/// then, as long as it is enough.
void lower_to(double low, const PartJob& job, BucklingResult& result) {
  const bool is_bound = result.is_lower_bound() &&
                        low >= part::wanted_buckling_factor(job.part.limits);
  result.band_low = low;
  if (is_bound) result.factor = result.band_high = low;
}

/// Where dead pressure pulls tubes straight that a fluid's bends on, the band
/// reaches down by twice that.
void lower_for_columns(const PartJob& job, BucklingResult& result) {
  double most = 0.0;  // over Euler's load
  for (const LoadSet& set : job.load_sets) {
    const double euler = load_of_bar(job, set);
    for (const loads::InstantLoad& instant : set.history.instants) {
      most = std::max(most, fluid_columns(job, instant) / euler);
    }
  }
  const double low = 1.0 / (1.0 / result.band_low + 2.0 * most);
  constexpr double kCounts = 0.99;
  if (low > kCounts * result.band_low) return;
  lower_to(low, job, result);
  result.remark +=
      result.remark.empty()
          ? "pressure keeps its direction; a fluid's in a long bore bends the "
            "part on as an axial load, which is in the band as of a bar"
          : "; in a long bore it bends the part on as an axial load, which is "
            "in the band as of a bar";
}

/// Pressure counts as a dead load. A fluid's turns with its face: a ring, or a
/// long tube, buckles under three quarters of it ([TimoshenkoGere]).
void lower_for_fluids(const PartJob& job, BucklingResult& result) {
  constexpr double kFollowing = 0.75;
  const auto presses = [&](const loads::InstantLoad& instant) {
    return instant.label == result.label &&
           std::ranges::any_of(instant.surface_loads, [](const auto& load) {
             return load.pressure > 0.0;
           });
  };
  if (std::ranges::none_of(job.load_sets, [&](const LoadSet& set) {
        return std::ranges::any_of(set.history.instants, presses);
      })) {
    return;
  }
  result.band_low *= kFollowing;
  result.remark =
      "pressure keeps its direction; a fluid's turns with its face, and may "
      "need a quarter less, which is in the band";
}

/// Of a history without supports, pins or a seat that clamps nothing tells what
/// holds the part: clamped at one end alone it buckles under a quarter of what
/// it does between two. The lowest factor counts, of whatever loads.
void lower_for_unknown_hold(const PartJob& job, BucklingResult& result) {
  constexpr double kOneEnd = 0.25;
  const bool is_unknown =
      std::ranges::any_of(job.load_sets, [&](const LoadSet& set) {
        const loads::LoadHistory& history = set.history;
        return !history.hold && set.fixed.empty() && set.foundations.empty() &&
               !history.instants.empty() && !history.instants.front().is_case &&
               loads::holding_groups(history).front().empty();
      });
  if (!is_unknown) return;
  lower_to(kOneEnd * result.band_low, job, result);
  if (!result.remark.empty()) result.remark += "; ";
  result.remark +=
      "nothing tells what holds the part: clamped at one end alone it buckles "
      "under a quarter, which is in the band";
}

double largest_of(const std::vector<Swing>& swings) {
  double largest = 1.0;
  for (const Swing& swing : swings) {
    largest = std::max(largest, swing.largest());
  }
  return largest;
}

}  // namespace

bool widen_by_all_holds(const PartJob& job, const std::vector<Swing>& swings,
                        BucklingModel& model, BucklingResult& result) {
  if (job.part.ideal_joints || result.if_all_hold || !result.factor ||
      std::ranges::none_of(job.load_sets, is_held_redundantly)) {
    return false;
  }
  const auto ideal =
      climb(job, model, largest_of(swings), checked_loads(job, true)).result;
  constexpr double kMore = 1.01;
  if (!ideal.factor || *ideal.factor < kMore * *result.factor) return false;
  result.if_all_hold = ideal.factor;
  result.band_high = ideal.band_high;
  const std::string more = fmt::format(
      "joints hold it more often than balance needs, of which only that counts "
      "here; {:.4g} if all hold, without play and yielding (joints = "
      "\"ideal\")",
      *ideal.factor);
  result.remark += (result.remark.empty() ? "" : "; ") + more;
  return true;
}

BucklingCheck check_buckling(const PartJob& job,
                             const std::vector<Swing>& swings,
                             BucklingModel& model) {
  Stopwatch watch;
  BucklingCheck check;
  if (job.load_sets.empty()) return check;
  const double swing = largest_of(swings);
  auto checked = checked_loads(job, job.part.ideal_joints);
  const bool is_one = checked.size() == 1;
  check = climb(job, model, swing, std::move(checked));
  auto others = other_sharings(job);
  // Loads on which it is not known count as their hold has them.
  if (!is_one || !others.empty()) {
    check.on_springs.together.is_known = false;
  }
  if (check.result.factor && !others.empty()) {
    const auto of_others = climb(job, model, swing, std::move(others)).result;
    check.result.band_low = std::min(check.result.band_low, of_others.band_low);
  }
  if (check.shape) lower_for_fluids(job, check.result);
  if (check.result.factor) {
    lower_for_columns(job, check.result);
    lower_for_unknown_hold(job, check.result);
  }
  const bool is_held_in_plane =
      std::ranges::any_of(job.load_sets, [&](const LoadSet& set) {
        return model.supports(set) != set.fixed;
      });
  if (check.shape && is_held_in_plane && check.result.remark.empty()) {
    check.result.remark =
        "across its plane it counts as held where it is held in it";
  }
  if (check.result.factor &&
      check.result.band_low < part::wanted_buckling_factor(job.part.limits)) {
    widen_by_all_holds(job, swings, model, check.result);
  }
  check.seconds = watch.lap();
  return check;
}

}  // namespace clevis::assessment
