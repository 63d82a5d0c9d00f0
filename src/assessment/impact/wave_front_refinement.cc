#include "assessment/impact/wave_front_refinement.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "assessment/impact/impact_rows.h"
#include "assessment/judge/sampled_peak.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Largest value within so many samples to either side.
VectorXd highest_near(const VectorXd& values, Index window) {
  VectorXd result(values.size());
  for (Index i = 0; i < values.size(); ++i) {
    const Index first = std::max<Index>(0, i - window);
    const Index last = std::min(values.size() - 1, i + window);
    result[i] = values.segment(first, last - first + 1).maxCoeff();
  }
  return result;
}

constexpr double kSettled = 0.05;
constexpr int kMoreShapes = 2;    // a cusp's top settles after its impulse
constexpr double kFastest = 2.0;  // cusps lose in proportion to the front

/// Remaining error of a geometric sequence, by its last two changes.
double left_over(double change, double before, double slowest) {
  if (change == 0.0) return 0.0;
  const double falls = std::clamp(std::abs(before / change), slowest, kFastest);
  return std::abs(change) / (falls - 1.0);
}

struct Left {
  double below{}, above{};
};

/// Error of a judged value by `error` and by a cusp between the samples.
/// @param curve  by the same fronts and more shapes.
Left left_of(const WaveFrontError& error, const VectorXd& curve,
             double judged) {
  const double scale = curve.maxCoeff() / judged;
  return {std::max(error.below, 1.0 - scale * (1.0 - error.below)),
          std::max(0.0, scale * (1.0 + error.above) - 1.0) +
              rise_between_samples(curve) / judged};
}

/// @param peaks  of each sample, by the fronts.
void name_competing_peak(const std::vector<VectorXd>& peaks, double time,
                         Index at, Index window, WaveFrontRefinement& found) {
  std::vector<double> stress;
  for (const VectorXd& by_front : peaks) {
    stress.push_back(highest_near(by_front, window)[at]);
  }
  if (stress.back() == found.stress.back()) return;
  found.competing_time = time;
  found.competing_stress = stress;
}

}  // namespace

template <int dim>
double shortest_wave_front(const mesh::PartMesh<dim>& mesh,
                           const part::Material& material, int degree) {
  const bool simplex = mesh.shape == mesh::CellShape::kSimplex;
  double longest = 0.0;
  for (const auto& cell : mesh.cells) {
    for (unsigned i = 0; i < cell.size(); ++i) {
      for (unsigned j = 0; j < i; ++j) {
        if (!simplex && !std::has_single_bit(i ^ j)) continue;  // no edge
        longest = std::max(
            longest, (mesh.vertices[cell[i]] - mesh.vertices[cell[j]]).norm());
      }
    }
  }
  return longest / degree *
         std::sqrt(material.density / material.youngs_modulus);
}

template <int dim>
bool has_short_wave_fronts(const StruckRun<dim>& run) {
  constexpr double kNoticed = 1e-6;
  return run.response.motion().energy_error > kNoticed;
}

template <int dim>
bool is_hard(const StruckRun<dim>& run) {
  constexpr int kManyShapes = 100;
  constexpr double kMuch = 1e-3;
  const auto& solution = run.response.solution;
  return solution.is_ideal || solution.modes > kManyShapes ||
         solution.run.energy_error > kMuch;
}

double slowest_fall(double rise) {
  constexpr double kSoft = 1.7;  // of cusps, 2 in the end
  const double last = std::sqrt(rise + 1.0) - std::sqrt(rise);
  return std::min(kSoft,
                  1.0 + (std::sqrt(rise + 2.0) - std::sqrt(rise + 1.0)) / last);
}

WaveFrontError wave_front_error(const VectorXd& one, const VectorXd& two,
                                const VectorXd& four, int window,
                                double slowest) {
  constexpr double kOvershoot = 0.1;
  const VectorXd a = highest_near(one, window), b = highest_near(two, window),
                 c = highest_near(four, window);
  const double peak = a.maxCoeff();
  WaveFrontError error;
  for (Index i = 0; i < a.size(); ++i) {
    const double left = left_over(a[i] - b[i], b[i] - c[i], slowest);
    const double above = (a[i] + left) / peak - 1.0;
    if (above > error.above) {
      error.above = above;
      error.at = i;
    }
    if (a[i] == peak && a[i] < b[i]) {
      error.below = std::max(error.below, left / peak);
    }
  }
  error.below = std::max(error.below, kOvershoot * error.above);
  return error;
}

template <int dim>
double stress_of_lost_energy(const StruckRun<dim>& run) {
  const auto& solution = run.response.solution;
  const double carried =
      std::min(1.0, 2.0 * solution.damping_time / solution.rise_time);
  return carried * std::sqrt(solution.run.energy_error) / run.factor;
}

template <int dim>
WaveFrontRefinement refine_wave_front(
    const PartJob& job, const ImpactJob& impact,
    const std::vector<stress::SingularZone>& zones, int degree,
    const StruckRun<dim>& judged, StruckFaces<dim>& faces) {
  const double front = judged.response.solution.damping_time;
  auto& face = faces.get(job, impact, degree);
  WaveFrontRefinement found;
  std::vector<VectorXd> peaks, roots;
  const auto add = [&](const elasticity::StrikeResponse<dim>& response) {
    peaks.push_back(judged_peaks(response.basis, job, zones));
    roots.push_back(support_peak(response.basis, job, impact).of_sample);
    found.fronts.push_back(response.solution.damping_time);
    found.stress.push_back(peaks.back().maxCoeff());
    found.deflection.push_back(
        stress::largest_deflection<dim>(response.basis).value);
  };
  for (const double times : {4.0, 2.0, 1.0}) {
    ImpactJob longer = impact;
    longer.front = times * front;
    auto options = strike_options(job, dynamics::Route::kModal, longer);
    if (times == 1.0) options.fewest_modes *= kMoreShapes;
    add(face.solve(impact.strike, options));
  }
  const auto& time = judged.response.motion().time;
  const auto window =
      static_cast<int>(std::ceil(4.0 * front / (time[1] - time[0])));
  const double slowest =
      slowest_fall(judged.response.solution.rise_time / front);
  const WaveFrontError error =
      wave_front_error(peaks[2], peaks[1], peaks[0], window, slowest);
  const auto bar = bar_of(job, impact);
  const double of_energy =
      bar && bar->is_rod ? 0.0 : stress_of_lost_energy(judged);
  const Left left = left_of(error, peaks[2], judged.stress);
  found.below = left.below;
  found.above = left.above + of_energy;
  if (roots[2].size() > 0) {
    const Left of_root =
        left_of(wave_front_error(roots[2], roots[1], roots[0], window, slowest),
                roots[2], judged.root.value);
    found.root_below = of_root.below;
    found.root_above = of_root.above + of_energy;
  }
  found.settles = found.below + found.above < kSettled;
  found.degree = degree;
  if (left.above > of_energy) {
    name_competing_peak(peaks, time[error.at], error.at, window, found);
  }
  return found;
}

#define CLEVIS_INSTANTIATE(dim)                                             \
  template double shortest_wave_front<dim>(const mesh::PartMesh<dim>&,      \
                                           const part::Material&, int);     \
  template bool has_short_wave_fronts<dim>(const StruckRun<dim>&);          \
  template bool is_hard<dim>(const StruckRun<dim>&);                        \
  template double stress_of_lost_energy<dim>(const StruckRun<dim>&);        \
  template WaveFrontRefinement refine_wave_front<dim>(                      \
      const PartJob&, const ImpactJob&,                                     \
      const std::vector<stress::SingularZone>&, int, const StruckRun<dim>&, \
      StruckFaces<dim>&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)

}  // namespace clevis::assessment
