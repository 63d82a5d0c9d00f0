#include "assessment/impact/late_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/impact/free_vibration.h"
#include "dynamics/strike/strike_steps.h"
#include "stress/displacement/deflection.h"

namespace clevis::assessment {
namespace {

constexpr int kSamplesPerDuration = 600;
constexpr int kLonger = 2, kPressed = 16;  // default durations
constexpr int kExtended = 4;  // beyond, courses of bouncing strikers part

struct Peaks {
  double stress{}, deflection{}, root{};

  Peaks with(const Peaks& other) const {
    return {std::max(stress, other.stress),
            std::max(deflection, other.deflection), std::max(root, other.root)};
  }
  BlowSpan span(double duration, const Peaks& all) const {
    const auto over = [](double later, double until) {
      return later > until ? later / until : 1.0;
    };
    return {duration, over(all.stress, stress),
            over(all.deflection, deflection),
            root > 0.0 ? over(all.root, root) : 1.0};
  }
};

/// Default duration [s].
double default_duration(const ImpactJob& impact, double contact_stiffness,
                        double part_stiffness, double first_period) {
  loads::Strike strike = impact.strike;
  strike.duration.reset();
  if (!std::isfinite(strike.contact.stiffness)) {
    strike.contact.stiffness = contact_stiffness;
  }
  const double omega = 2.0 * std::numbers::pi / first_period;
  return dynamics::strike_duration(strike, 1.0 / part_stiffness, omega * omega);
}

dynamics::StrikeOptions few_shapes(double damping, int samples, double front) {
  dynamics::StrikeOptions options;
  options.route = dynamics::Route::kModal;
  options.damping = dynamics::Damping::kFronts;
  options.wave_front_time = front;
  options.tolerance = 0.1;
  options.most_modes = options.fewest_modes * 3 / 2;
  options.samples = samples;
  options.modal_damping = damping;
  return options;
}

template <int dim>
Peaks peaks_of(const elasticity::DisplacementBasis<dim>& basis,
               const PartJob& job, const ImpactJob& impact,
               const std::vector<stress::SingularZone>& zones, int from,
               int to) {
  std::vector<int> samples;
  for (int i = from; i < to; ++i) samples.push_back(i);
  if (samples.empty()) return {};
  const auto some = at_samples(basis, samples);
  return {judged_stress(some, job, zones),
          stress::largest_deflection<dim>(some).value,
          support_peak(some, job, impact).value};
}

}  // namespace

template <int dim>
LateResponse late_response(const PartJob& job, const ImpactJob& impact,
                           const std::vector<stress::SingularZone>& zones,
                           int degree, const StruckRun<dim>& run,
                           double first_period, StruckFaces<dim>& faces) {
  const Eigen::VectorXd& time = run.response.motion().time;
  const double first = time[time.size() - 1];
  const double usual =
      default_duration(impact, run.response.solution.contact_stiffness,
                       run.response.stiffness, first_period);
  const int longer = impact.strike.force > 0.0 ? kPressed : kLonger;
  LateResponse found;
  found.looked_for = longer * std::max(first, usual);
  ImpactJob followed = impact;
  followed.strike.duration = found.looked_for;
  const int samples = longer * kSamplesPerDuration;
  const auto response =
      faces.get(job, impact, degree)
          .solve(followed.strike,
                 few_shapes(job.part.damping, samples, impact.front));
  const auto& basis = response.basis;
  const auto sample_at = [&](double t) {
    return std::min(
        samples, static_cast<int>(std::ceil(t / found.looked_for * samples)));
  };
  // until the first duration, twice, four times it, and the rest
  std::vector<double> ends{first};
  while (!impact.strike.duration && ends.back() < kExtended * first * 0.9 &&
         ends.back() < found.looked_for * 0.9) {
    ends.push_back(2.0 * ends.back());
  }
  std::vector<Peaks> until;
  int from = 0;
  for (const double end : ends) {
    const Peaks here =
        peaks_of(basis, job, impact, zones, from, sample_at(end) + 1);
    until.push_back(until.empty() ? here : here.with(until.back()));
    from = sample_at(end) + 1;
  }
  const Peaks all =
      peaks_of(basis, job, impact, zones, from, samples + 1).with(until.back());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    found.spans.push_back(until[i].span(ends[i], all));
    if (found.spans.back().holds_all()) break;
  }
  const double free_from = response.motion().release_time;
  if (free_from >= 0.0 && job.part.damping == 0.0) {
    const FreeVibration vibration = largest_free_vibration<dim>(
        basis, job.part.material, zones, sample_at(free_from));
    found.free_vibration_stress = vibration.stress / all.stress;
    found.free_vibration_deflection = vibration.deflection / all.deflection;
  }
  return found;
}

template LateResponse late_response<2>(const PartJob&, const ImpactJob&,
                                       const std::vector<stress::SingularZone>&,
                                       int, const StruckRun<2>&, double,
                                       StruckFaces<2>&);
template LateResponse late_response<3>(const PartJob&, const ImpactJob&,
                                       const std::vector<stress::SingularZone>&,
                                       int, const StruckRun<3>&, double,
                                       StruckFaces<3>&);

}  // namespace clevis::assessment
