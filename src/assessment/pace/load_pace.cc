#include "assessment/pace/load_pace.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "assessment/pace/acting_forces.h"
#include "loads/history/motion_instants.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// From the longest to the shortest, each so much of the one before.
VectorXd falling(double longest, double shortest, double step) {
  const auto count = static_cast<Index>(
      std::ceil(std::log(shortest / longest) / std::log(step)));
  VectorXd periods(count + 1);
  for (Index i = 0; i <= count; ++i) {
    periods[i] = longest * std::pow(step, static_cast<double>(i));
  }
  return periods;
}

/// Of the mechanism, at an end of a bar about its own mass there [kg].
double added_mass(const LoadSet& set, double width) {
  // A quarter of a clamped bar's mass moves with its end.
  constexpr double kAtTheEnd = 4.2, kGyration = 3.5;  // of the width: 1/√12
  if (!set.history.hold || !set.fixed.empty()) return 0.0;
  const MatrixXd weighed = set.history.hold_that_counts().weighed;
  double sum = 0.0;
  for (Index row = 0; row < weighed.rows(); ++row) {
    const bool turns = row % 6 >= 3;
    const double lever = turns ? kGyration / width : 1.0;
    sum += (lever * weighed.row(row)).squaredNorm();
  }
  return kAtTheEnd * sum;
}

// Of the first period or that of waves: shorter ones hold little of a load.
constexpr double kShortest = 0.02;

}  // namespace

LoadSet motion_loads(const LoadSet& set) {
  LoadSet motion = set;
  auto& all = motion.history.instants;
  all.resize(loads::motion_length(set.history));
  all.insert(all.end(), set.history.repeats.begin(), set.history.repeats.end());
  std::ranges::stable_sort(all, {}, &loads::InstantLoad::time);
  motion.history.repeats.clear();
  return motion;
}

LoadSet followed_loads(const LoadSet& set) {
  LoadSet motion = motion_loads(set);
  std::erase_if(motion.history.instants, [&](const loads::InstantLoad& load) {
    return load.time > set.history.followed_until;
  });
  return motion;
}

dynamics::LoadPath::Between between_instants(const LoadSet& set) {
  return set.history.rows ? dynamics::LoadPath::Between::kLinear
                          : dynamics::LoadPath::Between::kCubic;
}

dynamics::LoadPath load_components(const PartJob& job, const LoadSet& motion) {
  constexpr double kNothing = 1e-6, kRoundOff = 1e-8;
  const auto& instants = motion.history.instants;
  const auto length = static_cast<Index>(instants.size());
  if (length < 2) return {VectorXd(0), MatrixXd(0, 0), 0.0};
  const ActingForces acting(job, motion);
  MatrixXd forces = acting.values();
  const double largest = forces.lpNorm<Eigen::Infinity>();
  // What stands still excites nothing, however large beside what changes.
  forces.colwise() -= VectorXd(forces.col(0));
  const double change = forces.lpNorm<Eigen::Infinity>();
  MatrixXd components = acting.along_own_axes(
      forces, std::max(kNothing * change, kRoundOff * largest));
  components.array().colwise() /=
      components.rowwise().lpNorm<Eigen::Infinity>().array();
  VectorXd time(length);
  for (Index i = 0; i < length; ++i) {
    time[i] = instants[static_cast<std::size_t>(i)].time;
  }
  return {time, components,
          loads::kEventSides * loads::motion_duration(motion.history),
          between_instants(motion), motion.history.bends};
}

double period_of_waves(const PartJob& job) {
  return 2.0 * job.sides()[2] *
         std::sqrt(job.part.material.density /
                   job.part.material.youngs_modulus);
}

double longest_period(const PartJob& job, const LoadSet& set) {
  constexpr double kSure = 4.0;  // held at one end: 3.1
  const Eigen::Vector3d sides = job.sides();
  // A free bar of the mean thickness bends in half the waves' period times
  // length over thickness.
  const double thickness =
      job.mass.mass / job.part.material.density / (sides[1] * sides[2]);
  return kSure * period_of_waves(job) * std::max(1.0, sides[2] / thickness) *
         std::sqrt(1.0 + added_mass(set, sides[1]) / job.mass.mass);
}

double longest_period_in_plane(const PartJob& job) {
  constexpr double kSure = 4.0;
  const Eigen::Vector3d sides = job.sides();
  const double thickness =
      job.mass.mass / job.part.material.density / (sides[0] * sides[2]);
  return kSure * period_of_waves(job) * std::max(1.0, sides[2] / thickness);
}

double softest_period(const PartJob& job, const LoadSet& set) {
  constexpr double kSofter = 40.0;
  return kSofter * longest_period(job, set);
}

bool is_slow(const PartJob& job, const LoadSet& set,
             const dynamics::LoadPath& components) {
  constexpr double kStep = 0.9;
  const auto spectrum =
      response_spectrum(components,
                        falling(softest_period(job, set),
                                kShortest * period_of_waves(job), kStep),
                        job.part.damping, kPaceCounts);
  return spectrum.amplification <= kPaceCounts;
}

dynamics::ResponseSpectrum load_spectrum(const PartJob& job,
                                         const dynamics::LoadPath& components,
                                         double first) {
  constexpr double kStep = 0.95;
  const double shortest = kShortest * std::min(first, period_of_waves(job));
  return response_spectrum(components, falling(first, shortest, kStep),
                           job.part.damping, kPaceCounts);
}

double rise_near(const PartJob& job, const dynamics::LoadPath& components,
                 double first, double low, double high) {
  constexpr double kLeast = 0.01, kClosest = 2e-3;
  constexpr Index kBetween = 4;
  low = std::max(low, kLeast);
  if (!(low < high) || components.coordinates() == 0) return 1.0;
  const auto answer = [&](double frequency) {
    return response_spectrum(components,
                             VectorXd::Constant(1, first / frequency),
                             job.part.damping, kPaceCounts)
        .amplification;
  };
  // Half of a step beside a resonance of that width 0.89 of it is left.
  const double step = std::max(kClosest, job.part.damping);
  const double from = 0.5 * std::log(low), to = 0.5 * std::log(high);
  const auto count = static_cast<Index>((to - from) / step) + 2;
  const VectorXd near = VectorXd::LinSpaced(count, from, to);
  VectorXd answers(count);
  for (Index i = 0; i < count; ++i) answers[i] = answer(std::exp(near[i]));
  Index top = 0;
  double most = answers.maxCoeff(&top);
  for (const Index beside : {top - 1, top + 1}) {
    if (beside < 0 || beside == count) continue;
    for (Index k = 1; k < kBetween; ++k) {
      const double share = static_cast<double>(k) / kBetween;
      most = std::max(
          most, answer(std::exp(std::lerp(near[top], near[beside], share))));
    }
  }
  return std::max(1.0, most / answer(1.0));
}

}  // namespace clevis::assessment
