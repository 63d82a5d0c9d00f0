#include "assessment/notes/facet_doubt.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "assessment/job/model_traits.h"
#include "assessment/judge/doubt.h"
#include "mesh/derived/revolution.h"
#include "stress/corners/facet.h"
#include "stress/field/stress_history.h"

namespace clevis::assessment {
namespace {

/// Of the kink [rad]: what the field of a surface in facets is off by from
/// mid-facet (0.44) to a tenth of a facet from its ends (0.5 ... 0.8).
constexpr double kOfKink = 0.8;
constexpr double kSmall = 1e-3;  // of the peak: not told

/// The stress at the point of the lattice that is nearest to a place, at the
/// worst instant of all.
Eigen::Matrix3d stress_at(const PartFields& fields, const Eigen::Vector3d& at) {
  const auto field = fields.at(fields.peak_instant, fields.worst.subdivisions);
  double nearest = std::numeric_limits<double>::max();
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    Eigen::Index k = 0;
    const double distance = (field.points[c].rowwise() - at.transpose())
                                .rowwise()
                                .squaredNorm()
                                .minCoeff(&k);
    if (distance >= nearest) continue;
    nearest = distance;
    stress = stress::stress_tensor(field.stress[c].row(k));
  }
  return stress;
}

bool is_on_cylinder(const PartJob& job, const PeakStress& peak) {
  return std::ranges::any_of(job.groups, [&](const auto& group) {
    return group.is_cylinder && group.name == peak.group;
  });
}

/// @param stress  at the peak; zero: not known.
/// @param turned  by which the part was solved, or null.
/// @return over the peak [1].
double widen(const PartJob& job, const Eigen::Matrix3d& stress,
             const mesh::Revolution* turned, PeakStress& peak) {
  if (is_on_cylinder(job, peak)) return 0.0;
  double kink = 0.0;
  const auto& sets = job.load_sets;
  for (auto set = sets.begin(); set != sets.end(); ++set) {
    const bool is_known = std::any_of(sets.begin(), set, [&](const auto& s) {
      return s.fixed == set->fixed;
    });
    if (is_known) continue;
    kink = std::max(kink, stress::facet_kink(job.mesh, set->fixed, peak.at,
                                             stress, turned));
  }
  const double error = kOfKink * kink;
  if (error < kSmall) return 0.0;
  widen_for_cells(peak, error * peak.value, job.tolerance);
  return error;
}

}  // namespace

void add_facet_doubt(const PartJob& job, const PartFields& fields,
                     PartResult& result) {
  if (!(result.peak.value > 0.0) || !fields.at) return;
  const bool is_turned =
      result.model.starts_with(traits_of(ModelKind::kRevolution).name);
  const auto revolution =
      is_turned ? mesh::find_revolution(job.mesh) : std::nullopt;
  const mesh::Revolution* turned = revolution ? &*revolution : nullptr;
  const bool was_converged =
      judged_peak(result).verdict == PeakVerdict::kConverged;
  double error = 0.0;
  if (!is_on_cylinder(job, result.peak)) {  // else spared a whole field
    error = widen(job, stress_at(fields, result.peak.at), turned, result.peak);
  }
  if (result.peak_outside) {
    // Perhaps of another instant: its stress is not known here.
    error = std::max(error, widen(job, Eigen::Matrix3d::Zero(), turned,
                                  *result.peak_outside));
  }
  if (error == 0.0) return;
  if (was_converged &&
      judged_peak(result).verdict == PeakVerdict::kNotConverged) {
    result.stopped_because =
        fmt::format("faces that kink under the peak: {}, {:.3g} % wanted",
                    doubt_text(judged_peak(result)), 100.0 * job.tolerance);
  }
  result.notes.push_back(fmt::format(
      "the peak stands on {} that kink by {:.2g}°: the curve behind "
      "them may have {:.2g} % more or less, which is in the band; mesh {}, or "
      "name its arcs round_…",
      job.mesh.degree == 1 ? "flat facets" : "faces",
      error / kOfKink * 180.0 / std::numbers::pi, 100.0 * error,
      job.mesh.degree == 1 ? "with order 2" : "finer there"));
}

}  // namespace clevis::assessment
