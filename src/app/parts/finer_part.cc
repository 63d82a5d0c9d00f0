#include "app/parts/finer_part.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/parts/part_jobs.h"
#include "app/scenes/geometry_stamp.h"
#include "app/solids/solid_mesh.h"
#include "assessment/part_check.h"
#include "report/text/atomic_file.h"

namespace clevis::app {
namespace {

using assessment::PartJob;

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
  if (!part::is_solid_file(job.part.geometry) || job.is_shared) {
    return {job, assessment::check_part(job)};
  }
  const auto index = static_cast<std::size_t>(
      std::ranges::find(loaded.scene.parts, job.part.name,
                        &part::PartDefinition::name) -
      loaded.scene.parts.begin());
  return check_in_rounds(
      job, rounds, assessment::check_part, [&](const cad::Refinement& finer) {
        write_finer_mesh(job.part, loaded.scene.inputs[index], finer);
        return job_anew(loaded, index, motion, job);
      });
}

}  // namespace clevis::app
