#include "app/commands/mesh_command.h"

#include <chrono>
#include <fstream>
#include <iostream>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "app/processes/temporary_folder.h"
#include "app/scenes/geometry_files.h"
#include "app/scenes/geometry_stamp.h"
#include "app/scenes/gmsh_runner.h"
#include "base/errors.h"
#include "mesh/reading/mesh_reader.h"
#include "report/text/atomic_file.h"
#include "scene/scene.h"
#include "scene/text/name_index.h"
#include "scene/text/suggestion.h"

namespace clevis::app {
namespace {

using part::PartDefinition;

/// The parts that have a .geo, or those of them that the user named.
/// @throws Error S007 if a named part does not exist, S003 if it has no .geo.
std::vector<PartDefinition> parts_to_mesh(
    const scene::Scene& scene, const std::vector<std::string>& names) {
  std::set<std::string_view> wanted(names.begin(), names.end());
  std::vector<std::string_view> known;
  std::vector<PartDefinition> result;
  for (const PartDefinition& part : scene.parts) {
    known.push_back(part.name);
    const bool named = wanted.erase(part.name) > 0;
    if (named && part.geometry.empty()) {
      throw Error("S003", part.place,
                  fmt::format("part {} has no `geometry` to mesh", part.name),
                  "Give the part a .geo, or make its mesh yourself.");
    }
    if (!part.geometry.empty() && (named || names.empty())) {
      result.push_back(part);
    }
  }
  if (!wanted.empty()) {
    const std::string_view unknown = *wanted.begin();
    throw Error("S007", "--part",
                fmt::format("the scene has no part \"{}\"", unknown),
                scene::suggestion(unknown, known));
  }
  return result;
}

/// The mesh that the text of a .msh holds, through the same validation as in
/// `check`: what does not pass is not kept.
mesh::PartMesh<3> gated(const std::string& text, const PartDefinition& part) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / part.mesh.filename();
  std::ofstream(file, std::ios::binary) << text;
  return mesh::read_part_mesh(file, part.length_unit, part.thickness);
}

void mesh_part(const PartDefinition& part) {
  const auto start = std::chrono::steady_clock::now();
  // Hashed before gmsh reads it: an edit in between leaves the mesh stale.
  const std::string stamp = geometry_stamp(geometry_content(part.geometry));
  const std::string text = stamped(run_gmsh(part.geometry), stamp);
  const mesh::PartMesh<3> mesh = gated(text, part);
  report::write_file(part.mesh, text);
  const std::chrono::duration<double> elapsed =
      std::chrono::steady_clock::now() - start;
  std::cout << fmt::format("{}: {} cells, {} vertices -> {} ({:.2f} s)\n",
                           part.name, mesh.cells.size(), mesh.vertices.size(),
                           part.mesh.string(), elapsed.count());
  for (const std::string& group : mesh.empty_groups) {
    std::cout << fmt::format(
        "{}: the physical group {} holds no surface of the part\n", part.name,
        group);
  }
}

}  // namespace

ExitCode mesh_command(const Options& options) {
  const scene::Scene scene = scene::read_scene(options.scene);
  const std::vector<PartDefinition> parts = parts_to_mesh(scene, options.parts);
  if (parts.empty()) {
    std::cout << "no part of the scene has a geometry: nothing to mesh\n";
  }
  std::set<std::filesystem::path> done;
  for (const PartDefinition& part : parts) {
    if (done.insert(part.mesh).second) mesh_part(part);
  }
  return ExitCode::kPass;
}

}  // namespace clevis::app
