#include "assessment/models/model_error.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/job/part_zones.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/plate/layered_solve.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/field/stress_history.h"
#include "stress/peaks/peak_zoom.h"
#include "stress/zones/singular_zone.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {
namespace {

using Eigen::VectorXd;

constexpr int kFewestTerms = traits_of(ModelKind::kLayered).fewest_terms;
constexpr int kMostTerms = traits_of(ModelKind::kLayered).most_terms;
constexpr int kFirstDegree = 2;
constexpr int kDegree = 3;       // of plane stress: 2 doubles its difference
constexpr int kTermsDegree = 2;  // of terms among each other
// Where pressures have a kink within the thickness: terms converge slowly, to
// and fro, and degree 2 hides half of that.
constexpr int kKinkedDegree = 3, kMostKinkedTerms = 6;
constexpr int kPlaneSubdivisions = 8;

elasticity::ElasticProblem<2> problem(const PartJob& job,
                                      const mesh::PartMesh<2>& plate,
                                      const LoadSet& set) {
  return {.mesh = plate,
          .material = job.part.material,
          .history = set.history,
          .fixed = set.fixed,
          .name = job.part.name,
          .max_dofs = job.max_dofs};
}

/// Peak of each instant of a set; away from singular zones, where there are
/// any, of those points where that instant is the worst.
template <int dim>
VectorXd peaks_of(const PartJob& job, const mesh::PartMesh<2>& plate,
                  const LoadSet& set,
                  const elasticity::DisplacementBasis<dim>& basis,
                  int subdivisions) {
  const auto history =
      stress::stress_history<dim>(basis, job.part.material, subdivisions);
  const auto zones = plate_zones<dim>(job, plate, set);
  if (zones.empty() && history.largest() > 0.0) {
    // Bending has its peak beside the face of a plate: between the points.
    return history.peak / history.largest() *
           stress::field_maximum<dim>(basis, job.part.material, history);
  }
  if (zones.empty()) return history.peak;
  const auto zone_of =
      stress::zone_of_points<dim>(basis.discretization, subdivisions, zones);
  VectorXd peaks = VectorXd::Zero(history.peak.size());
  for (Eigen::Index cell = 0; cell < zone_of.cols(); ++cell) {
    for (Eigen::Index point = 0; point < zone_of.rows(); ++point) {
      if (zone_of(point, cell) >= 0) continue;
      double& peak = peaks[history.worst_instant(point, cell)];
      peak = std::max(peak, history.worst(point, cell));
    }
  }
  return peaks;
}

VectorXd plane_peaks(const PartJob& job, const mesh::PartMesh<2>& plate,
                     const LoadSet& set, int degree) {
  return peaks_of<2>(job, plate, set,
                     elasticity::solve<2>(problem(job, plate, set), degree),
                     kPlaneSubdivisions);
}

/// The lattice's own error must stay below the difference that matters.
int subdivisions(const PartJob& job) {
  constexpr double kFine = 0.005;
  return job.tolerance < kFine ? 8 : 4;
}

VectorXd layered_peaks(const PartJob& job, const mesh::PartMesh<2>& plate,
                       const LoadSet& set, int degree, int terms) {
  return peaks_of<3>(
      job, plate, set,
      elasticity::solve_layered(problem(job, plate, set), degree, terms),
      subdivisions(job));
}

/// Peaks of all governing instants, set after set; of a set with singular
/// zones the largest alone: in another model another instant may be a point's
/// worst.
template <class Peaks>
VectorXd all_peaks(const PartJob& job, const mesh::PartMesh<2>& plate,
                   const std::vector<LoadSet>& sets, const Peaks& peaks_of) {
  VectorXd all;
  for (const LoadSet& set : sets) {
    VectorXd peaks = peaks_of(set);
    if (!plate_zones<2>(job, plate, set).empty()) {
      peaks = VectorXd::Constant(1, peaks.maxCoeff());
    }
    all.conservativeResize(all.size() + peaks.size());
    all.tail(peaks.size()) = peaks;
  }
  return all;
}

/// Largest difference at an instant over the largest peak.
double difference(const VectorXd& ours, const VectorXd& theirs) {
  const double largest = theirs.maxCoeff();
  if (!(largest > 0.0)) return 0.0;
  return (ours - theirs).cwiseAbs().maxCoeff() / largest;
}

/// The instant of the largest peak and the largest ones away from it.
std::vector<std::size_t> highest_instants(VectorXd peaks, double floor) {
  constexpr int kMost = 3;
  std::vector<std::size_t> found;
  const Eigen::Index apart = std::max<Eigen::Index>(1, peaks.size() / 10);
  while (static_cast<int>(found.size()) < kMost) {
    Eigen::Index at = 0;
    const double largest = peaks.maxCoeff(&at);
    if (largest < floor) break;
    found.push_back(static_cast<std::size_t>(at));
    const Eigen::Index begin = std::max<Eigen::Index>(0, at - apart + 1);
    const Eigen::Index end = std::min(peaks.size(), at + apart);
    peaks.segment(begin, end - begin).setConstant(-1.0);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

template <int dim>
std::vector<stress::SingularZone> plate_zones(const PartJob& job,
                                              const mesh::PartMesh<2>& plate,
                                              const LoadSet& set) {
  auto zones = part_zones<2>(job, plate, set);
  if constexpr (dim == 3) {
    const Eigen::Vector3d half(0.0, 0.0, 0.5 * plate.thickness);
    for (auto& zone : zones) {
      for (auto& [from, to] : zone.edges) {
        from -= half;
        to += half;
      }
    }
  }
  return zones;
}

template std::vector<stress::SingularZone> plate_zones<2>(
    const PartJob&, const mesh::PartMesh<2>&, const LoadSet&);
template std::vector<stress::SingularZone> plate_zones<3>(
    const PartJob&, const mesh::PartMesh<2>&, const LoadSet&);

std::vector<LoadSet> governing_loads(const PartJob& job,
                                     const mesh::PartMesh<2>& plate,
                                     bool in_plane) {
  constexpr double kNear = 0.9;
  std::vector<VectorXd> peaks;
  double largest = 0.0;
  for (const LoadSet& set : job.load_sets) {
    peaks.push_back(
        in_plane ? plane_peaks(job, plate, set, kFirstDegree)
                 : layered_peaks(job, plate, set, kFirstDegree, kFewestTerms));
    largest = std::max(largest, peaks.back().maxCoeff());
  }
  std::vector<LoadSet> governing;
  for (std::size_t s = 0; s < peaks.size(); ++s) {
    const LoadSet& set = job.load_sets[s];
    LoadSet few{{set.history.seats, {}}, set.fixed};
    for (const std::size_t i : highest_instants(peaks[s], kNear * largest)) {
      few.history.instants.push_back(set.history.instants[i]);
    }
    if (!few.history.instants.empty()) governing.push_back(std::move(few));
  }
  return governing;
}

double plane_stress_error(const PartJob& job, const mesh::PartMesh<2>& plate,
                          const std::vector<LoadSet>& governing) {
  constexpr int kTerms = 4;      // fewer may agree with plane stress by chance
  constexpr double kRest = 1.2;  // for what a higher degree would change
  const VectorXd plane =
      all_peaks(job, plate, governing, [&](const LoadSet& set) {
        return plane_peaks(job, plate, set, kDegree);
      });
  const VectorXd layered =
      all_peaks(job, plate, governing, [&](const LoadSet& set) {
        return layered_peaks(job, plate, set, kDegree, kTerms);
      });
  return kRest * difference(plane, layered);
}

bool plane_stress_is_far(const PartJob& job, const mesh::PartMesh<2>& plate,
                         const std::vector<LoadSet>& governing) {
  constexpr double kSure = 2.5;  // what degree and terms may feign
  const VectorXd plane =
      all_peaks(job, plate, governing, [&](const LoadSet& set) {
        return plane_peaks(job, plate, set, kFirstDegree);
      });
  const VectorXd layered =
      all_peaks(job, plate, governing, [&](const LoadSet& set) {
        return layered_peaks(job, plate, set, kFirstDegree, kFewestTerms);
      });
  return difference(plane, layered) > kSure * job.tolerance;
}

bool terms_cost_more(const PartJob& job, const mesh::PartMesh<2>& plate) {
  constexpr double kFlopsPerSecond = 3e10;  // one core of 2020
  constexpr double kFewSeconds = 2.0;
  // Where a peak converges slowly: the highest degree, and of hexahedra that
  // after which finer solutions near the peak tell the rest.
  constexpr int kTerms = 3, kSolidDegree = 3;
  constexpr double kUnknowns = 3.0;  // of a node, and of a term
  const auto flops = [](double unknowns, const auto& part) {
    return std::pow(unknowns, 3.0) * elasticity::dissect(part).flops;
  };
  const double layered =
      flops(kUnknowns * kTerms,
            elasticity::discretize<2>(
                plate, traits_of(ModelKind::kLayered).highest_degree));
  if (layered < kFewSeconds * kFlopsPerSecond) return false;
  return layered >
         flops(kUnknowns, elasticity::discretize<3>(job.mesh, kSolidDegree));
}

namespace {

/// Peaks by terms through the thickness, each number of them solved once.
class TermPeaks {
 public:
  TermPeaks(const PartJob& job, const mesh::PartMesh<2>& plate,
            const std::vector<LoadSet>& governing, int degree)
      : job_(job), plate_(plate), governing_(governing), degree_(degree) {}

  /// What one and two more terms change, and a part for even more; over the
  /// peak [1].
  double error(int terms) {
    constexpr double kRest = 1.5;
    const VectorXd& ours = of(terms);
    return kRest * std::max(difference(ours, of(terms + 1)),
                            difference(ours, of(terms + 2)));
  }

 private:
  const VectorXd& of(int terms) {
    const auto [found, is_new] = peaks_.try_emplace(terms);
    if (is_new) {
      found->second =
          all_peaks(job_, plate_, governing_, [&](const LoadSet& set) {
            return layered_peaks(job_, plate_, set, degree_, terms);
          });
    }
    return found->second;
  }

  const PartJob& job_;
  const mesh::PartMesh<2>& plate_;
  const std::vector<LoadSet>& governing_;
  int degree_;
  std::map<int, VectorXd> peaks_;  ///< stay where they are
};

}  // namespace

ThicknessChoice choose_terms(const PartJob& job, const mesh::PartMesh<2>& plate,
                             const std::vector<LoadSet>& governing,
                             bool is_pressed_through, double allowed) {
  TermPeaks peaks(job, plate, governing,
                  is_pressed_through ? kTermsDegree : kKinkedDegree);
  const int most = is_pressed_through ? kMostTerms : kMostKinkedTerms;
  ThicknessChoice choice;
  for (int terms = kFewestTerms; terms <= most; ++terms) {
    choice = {terms, peaks.error(terms)};
    if (choice.model_error <= allowed) break;
  }
  return choice;
}

double kink_error(const PartJob& job, const mesh::PartMesh<2>& plate,
                  const std::vector<LoadSet>& governing, std::size_t layers) {
  if (layers > 2) return 0.0;
  return TermPeaks(job, plate, governing, kKinkedDegree)
      .error(layers == 2 ? kMostKinkedTerms : kMostTerms);
}

}  // namespace clevis::assessment
