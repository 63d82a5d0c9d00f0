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
#include "base/messages/errors.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/dof_limit.h"
#include "loads/history/balance.h"
#include "report/text/atomic_file.h"

namespace clevis::app {
namespace {

using assessment::PartJob;

/// Three degrees have a band: a mesh on which the third is above --max-dofs, or
/// without it takes minutes, is worse than the one before it.
/// @throws Error F007.
void require_a_band(const mesh::PartMesh<3>& mesh, const PartJob& job) {
  constexpr int kDegreesOfABand = 3;
  constexpr std::size_t kMostCells = 50000;  // some 700 000 unknowns
  if (!job.max_dofs && mesh.cells.size() > kMostCells) {
    throw Error("F007", "part " + job.part.name,
                fmt::format("a finer mesh would have {} cells and take minutes",
                            mesh.cells.size()),
                "Give --max-dofs, or the part a mesh_size, if it may.");
  }
  if (!job.max_dofs) return;
  elasticity::require_dofs(
      elasticity::discretize<3>(mesh, kDegreesOfABand).dofs(), job.max_dofs,
      "part " + job.part.name);
}

/// Writes a finer mesh of the part in the place of its own.
void write_finer_mesh(const PartJob& job, const part::GeometryInput& input,
                      const cad::Refinement& finer, bool in_space) {
  const part::PartDefinition& part = job.part;
  const std::string stamp = geometry_stamp(part, input);
  part::SolidSource source = input.solid;
  if (in_space) source.sweep = false;
  const SolidMesh made = mesh_solid_part(part, source, finer);
  require_a_band(made.mesh, job);
  report::write_file(part.mesh, stamped(made.text, stamp));
}

/// The same part with the mesh that its file holds now.
PartJob job_anew(const LoadedScene& loaded, std::size_t index,
                 const mechanism::Motion& motion, const PartJob& job) {
  LoadedScene changed = loaded;
  LoadedPart& part = changed.parts[index];
  part = load_part(loaded.scene.parts[index], loaded.scene.inputs[index]);
  // Curved faces make the masses of two meshes differ by their cells' size.
  const part::MassProperties mass =
      std::exchange(part.mass, loaded.parts[index].mass);
  PartJob again = std::move(
      part_jobs(changed, motion, {job.part.name}, job.tolerance).front());
  again.mass = mass;
  const auto floats = [](const assessment::LoadSet& set) {
    return set.fixed.empty() && set.foundations.empty();
  };
  for (assessment::LoadSet& set : again.load_sets) {
    if (floats(set)) loads::float_on(mass, set.history);
  }
  for (assessment::OpenSharing& sharing : again.open_sharings) {
    if (!floats(again.load_sets[sharing.set])) continue;
    loads::float_on(mass, sharing.checked);
    for (loads::LoadHistory& other : sharing.others)
      loads::float_on(mass, other);
  }
  again.model = job.model;
  again.engine = job.engine;
  again.max_dofs = job.max_dofs;
  return again;
}

}  // namespace

CheckedPart check_on_finer_meshes(const LoadedScene& loaded,
                                  const mechanism::Motion& motion,
                                  const PartJob& job,
                                  const RoundLimits& limits) {
  if (!part::is_solid_file(job.part.geometry) || job.is_shared) {
    assessment::PartAssessment assessment = assessment::check_part(job);
    return {job, std::move(assessment)};  // copied when its memory is free
  }
  const auto index = static_cast<std::size_t>(
      std::ranges::find(loaded.scene.parts, job.part.name,
                        &part::PartDefinition::name) -
      loaded.scene.parts.begin());
  return check_in_rounds(job, limits, assessment::check_part,
                         [&](const cad::Refinement& finer, bool in_space) {
                           write_finer_mesh(job, loaded.scene.inputs[index],
                                            finer, in_space);
                           return job_anew(loaded, index, motion, job);
                         });
}

}  // namespace clevis::app
