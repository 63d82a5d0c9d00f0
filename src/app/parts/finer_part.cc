#include "app/parts/finer_part.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/parts/part_jobs.h"
#include "app/scenes/geometry_stamp.h"
#include "app/solids/solid_mesh.h"
#include "assessment/part_check.h"
#include "base/errors.h"
#include "report/text/atomic_file.h"

namespace clevis::app {
namespace {

using assessment::PartJob;
using assessment::PartResult;
using assessment::PeakStress;

/// How far the mesh leaves the judged peak open, if that is too far [1].
std::optional<double> open_by(const PartResult& result, double tolerance) {
  const PeakStress& peak = judged_peak(result);
  const double open = peak.shares.mesh / peak.value;
  if (peak.verdict != assessment::PeakVerdict::kNotConverged ||
      !(open > tolerance)) {
    return std::nullopt;
  }
  return open;
}

/// Writes a finer mesh of the part in the place of its own.
void write_finer_mesh(const part::PartDefinition& part,
                      const part::GeometryInput& input,
                      const cad::Refinement& finer) {
  const std::string stamp = geometry_stamp(part, input);
  const SolidMesh made = mesh_solid_part(part, input.solid, finer);
  report::write_file(part.mesh, stamped(made.text, stamp));
}

/// The same part with the mesh that its file holds now.
PartJob job_anew(const LoadedScene& loaded, std::size_t index,
                 const mechanism::Motion& motion, const PartJob& job) {
  LoadedScene changed = loaded;
  changed.parts[index] =
      load_part(loaded.scene.parts[index], loaded.scene.inputs[index]);
  PartJob again = std::move(
      part_jobs(changed, motion, {job.part.name}, job.tolerance).front());
  again.model = job.model;
  again.engine = job.engine;
  return again;
}

}  // namespace

CheckedPart check_on_finer_meshes(const LoadedScene& loaded,
                                  const mechanism::Motion& motion,
                                  const PartJob& job, int rounds) {
  constexpr double kFiner = 1.25;    // everywhere, in each round
  constexpr int kMostCells = 20000;  // the next mesh would take minutes
  CheckedPart checked{job, assessment::check_part(job)};
  if (!part::is_solid_file(job.part.geometry) || job.is_shared) return checked;
  const auto index = static_cast<std::size_t>(
      std::ranges::find(loaded.scene.parts, job.part.name,
                        &part::PartDefinition::name) -
      loaded.scene.parts.begin());
  cad::Refinement finer;
  std::vector<std::string> told;
  for (int round = 1; round <= rounds; ++round) {
    const PartResult& result = checked.assessment.result;
    const auto open = open_by(result, job.tolerance);
    if (!open) break;
    if (result.cells > kMostCells) {
      told.push_back(
          fmt::format("{} cells leave {:.3g} % open; a finer mesh would take "
                      "minutes: give the part a mesh_size if it may",
                      result.cells, 100.0 * *open));
      break;
    }
    finer.everywhere = std::pow(kFiner, round);
    finer.at.push_back(judged_peak(result).at);
    write_finer_mesh(job.part, loaded.scene.inputs[index], finer);
    PartJob again = job_anew(loaded, index, motion, job);
    told.push_back(fmt::format(
        "meshed finer, most at the peak: {} cells left {:.3g} % open, now {}",
        result.cells, 100.0 * *open, again.mesh.cells.size()));
    auto assessment = assessment::check_part(again);
    checked = {std::move(again), std::move(assessment)};
  }
  auto& notes = checked.assessment.result.notes;
  notes.insert(notes.end(), told.begin(), told.end());
  return checked;
}

}  // namespace clevis::app
