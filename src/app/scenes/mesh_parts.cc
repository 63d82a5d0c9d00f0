#include "app/scenes/mesh_parts.h"

#include <chrono>
#include <ostream>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/scenes/geometry_constants.h"
#include "app/scenes/geometry_stamp.h"
#include "app/scenes/gmsh_runner.h"
#include "app/solids/solid_mesh.h"
#include "app/solids/validated_mesh.h"
#include "base/messages/errors.h"
#include "base/system/mpi_run.h"
#include "report/text/atomic_file.h"
#include "scene/scene.h"
#include "scene/text/name_index.h"

namespace clevis::app {
namespace {

using part::PartDefinition;

struct GeometryPart {
  PartDefinition part;
  part::GeometryInput input;
};

/// The parts that have a geometry, or those of them that the user named.
/// @throws Error S007 if a named part does not exist, S003 if it has none.
std::vector<GeometryPart> parts_to_mesh(const scene::Scene& scene,
                                        const std::vector<std::string>& names) {
  std::set<std::string_view> wanted(names.begin(), names.end());
  std::vector<std::string_view> known;
  std::vector<GeometryPart> result;
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    const PartDefinition& part = scene.parts[p];
    known.push_back(part.name);
    const bool named = wanted.erase(part.name) > 0;
    if (named && part.geometry.empty()) {
      throw Error("S003", part.place,
                  fmt::format("part {} has no `geometry` to mesh", part.name),
                  "Give the part a .geo or a STEP file, or make its mesh "
                  "yourself.");
    }
    if (!part.geometry.empty() && (named || names.empty())) {
      result.push_back({part, scene.inputs[p]});
    }
  }
  if (!wanted.empty()) {
    const std::string_view unknown = *wanted.begin();
    throw Error("U001", "--part",
                fmt::format("the scene has no part \"{}\"", unknown),
                fmt::format("Its parts: {}.", fmt::join(known, ", ")));
  }
  return result;
}

/// A mesh that `check` would take.
struct MadeMesh {
  std::string text;  ///< .msh with its stamp
  mesh::PartMesh<3> mesh;
};

MadeMesh mesh_of_script(const GeometryPart& source, const std::string& stamp) {
  const auto& [part, input] = source;
  require_constants(part.geometry, input.parameters);
  std::string text = stamped(run_gmsh(part.geometry, input.parameters), stamp);
  return {text, validated_mesh(text, part).mesh};
}

MadeMesh mesh_of_solid(const GeometryPart& source, const std::string& stamp,
                       std::ostream& log) {
  const auto& [part, input] = source;
  SolidMesh made = mesh_solid_part(part, input.solid);
  for (const std::string& line : made.told)
    log << part.name << ": " << line << '\n';
  return {stamped(std::move(made.text), stamp), std::move(made.mesh)};
}

void mesh_part(const GeometryPart& source, std::ostream& log) {
  const auto& [part, input] = source;
  const auto start = std::chrono::steady_clock::now();
  // Hashed before gmsh reads it: an edit in between leaves the mesh stale.
  const std::string stamp = geometry_stamp(part, input);
  const auto [text, mesh] = part::is_solid_file(part.geometry)
                                ? mesh_of_solid(source, stamp, log)
                                : mesh_of_script(source, stamp);
  report::write_file(part.mesh, text);
  const std::chrono::duration<double> elapsed =
      std::chrono::steady_clock::now() - start;
  log << fmt::format("{}: {} cells, {} vertices -> {} ({:.2f} s)\n", part.name,
                     mesh.cells.size(), mesh.vertices.size(),
                     part.mesh.string(), elapsed.count());
  for (const std::string& group : mesh.empty_groups) {
    log << fmt::format(
        "{}: the physical group {} holds no surface of the part\n", part.name,
        group);
  }
}

/// A mesh without a stamp is the user's own, one without its geometry all there
/// is.
bool is_current(const GeometryPart& source) {
  const auto& [part, input] = source;
  std::error_code failure;
  return std::filesystem::is_regular_file(part.mesh, failure) &&
         (has_current_mesh(part, input) || !stamp_of(part.mesh) ||
          !std::filesystem::is_regular_file(part.geometry, failure));
}

}  // namespace

std::size_t mesh_parts(const Options& options, MeshWhich which,
                       std::ostream& log) {
  const scene::Scene scene = scene::read_scene(options.scene, options.settings);
  // A check of one part needs the masses of all.
  const bool all_parts = which != MeshWhich::kAll;
  const auto sources = parts_to_mesh(
      scene, all_parts ? std::vector<std::string>() : options.parts);
  std::set<std::filesystem::path> done;
  for (const GeometryPart& source : sources) {
    if (!done.insert(source.part.mesh).second) continue;
    if (all_parts && is_current(source)) continue;
    mesh_part(source, log);
  }
  return sources.size();
}

void mesh_solids(const scene::Scene& scene, std::ostream& log) {
  if (mpi_ranks() > 1) return;  // they would write one file together
  std::set<std::filesystem::path> done;
  for (const GeometryPart& source : parts_to_mesh(scene, {})) {
    if (!part::is_solid_file(source.part.geometry)) continue;
    if (!done.insert(source.part.mesh).second || is_current(source)) continue;
    mesh_part(source, log);
  }
}

scene::Scene scene_to_solve(const Options& options, std::ostream& log) {
  scene::Scene scene = scene::read_scene(options.scene, options.settings);
  mesh_solids(scene, log);
  return scene;
}

}  // namespace clevis::app
