#include "app/solids/solid_mesh.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/solids/solid_mesher.h"
#include "app/solids/validated_mesh.h"
#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "cad/face_groups.h"
#include "cad/plate.h"
#include "cad/select_faces.h"

namespace clevis::app {
namespace {

/// Cells that a mesh of some size [m] has at least, over those that gmsh makes
/// within its time: tetrahedra, or hexahedra of a plate in its plane.
double share_of_time(const cad::Solid& solid, const part::SolidSource& source,
                     double size) {
  constexpr double kMostTetrahedra = 1e6, kMostHexahedra = 2e5;
  constexpr double kOfCube = 4.5;  // tetrahedra, as gmsh makes them
  const auto plate = cad::plate_of(solid);
  return plate && source.sweep
             ? solid.volume / plate->thickness / std::pow(size, 2.0) /
                   kMostHexahedra
             : kOfCube * solid.volume / std::pow(size, 3.0) / kMostTetrahedra;
}

/// @throws Error M010 if the mesher could not end within its time.
void require_few_cells(const cad::Solid& solid,
                       const part::PartDefinition& part,
                       const part::SolidSource& source) {
  if (!source.mesh_size) return;
  const double size = *source.mesh_size;
  const double share = share_of_time(solid, source, size);
  if (share <= 1.0) return;
  double enough = size;
  while (share_of_time(solid, source, enough) > 1.0) enough *= 1.05;
  throw Error(
      "M010", source.mesh_size_place,
      fmt::format("part {}: mesh_size = {:.4g} mm makes some {:.2g} times as "
                  "many cells of {} as the mesher can",
                  part.name, 1e3 * size, share,
                  part.geometry.filename().string()),
      fmt::format("Give {:.2g} mm or more, or leave it out: cells are made "
                  "smaller by themselves where stresses ask for it.",
                  1e3 * enough));
}

/// A size that no edge of the solid reaches is a number of another unit.
void note_large_cells(const cad::Solid& solid, const part::SolidSource& source,
                      std::vector<std::string>& told) {
  if (!source.mesh_size) return;
  const double longest = (solid.high - solid.low).maxCoeff();
  if (*source.mesh_size <= longest) return;
  told.push_back(
      fmt::format("mesh_size = {:.4g} mm is more than the longest side, {:.4g} "
                  "mm: see that "
                  "its unit is right",
                  1e3 * *source.mesh_size, 1e3 * longest));
}

/// A mesh that is valid; curved cells that fold there (M005) do not in a
/// finer mesh.
SolidMesh unfolded_mesh(const part::PartDefinition& part,
                        cad::Request request) {
  constexpr double kFiner = 1.4;
  constexpr int kMostTimes = 3;
  for (int time = 1;; ++time) {
    SolidMesh made;
    made.text = run_mesher(request).mesh;
    try {
      made.mesh = validated_mesh(made.text, part).mesh;
      return made;
    } catch (const Error& error) {
      if (error.code() != "M005" || time == kMostTimes) throw;
    }
    request.finer.everywhere *= kFiner;
  }
}

/// A plate in its plane, if it is one and that can be; else in space.
/// @param told  says which, of a plate.
SolidMesh swept_mesh(const part::PartDefinition& part,
                     const part::SolidSource& source, const cad::Solid& solid,
                     cad::Request request, std::vector<std::string>& told) {
  request.plate = cad::plate_of(solid);
  if (!request.plate) return unfolded_mesh(part, request);
  const std::string what = cad::text(*request.plate);
  if (source.sweep) {
    Stopwatch taken;
    try {
      SolidMesh made = unfolded_mesh(part, request);
      told.push_back(what + ": meshed in its plane" +
                     (request.plate->is_along_z()
                          ? ""
                          : "; models of plates know such along z alone, so it "
                            "is solved in space"));
      return made;
    } catch (const Error& error) {
      // In space it would take as long again.
      const bool is_late = taken.lap() > kMostToMesh.count();
      if (is_late || !error.code().starts_with('M')) throw;
      told.push_back(fmt::format("{}, meshed in space all the same: {}", what,
                                 error.problem()));
    }
  }
  request.plate.reset();
  return unfolded_mesh(part, request);
}

}  // namespace

std::string about(const cad::Solid& solid) {
  const Eigen::Vector3d size = 1e3 * (solid.high - solid.low);
  return fmt::format(
      "unit {}, {:.4g} x {:.4g} x {:.4g} mm, {:.6g} cm^3, {} "
      "faces",
      solid.unit.empty() ? "not given" : solid.unit, size.x(), size.y(),
      size.z(), 1e6 * solid.volume, solid.faces.size());
}

SolidMesh mesh_solid_part(const part::PartDefinition& part,
                          const part::SolidSource& source,
                          const cad::Refinement& finer) {
  cad::Request request;
  request.file = part.geometry;
  request.length_unit = source.length_unit;
  request.points = cad::points_of(source);
  const cad::Solid solid = run_mesher(request).solid;
  require_few_cells(solid, part, source);
  cad::FaceGroups groups = cad::face_groups(solid, request.points, source);
  cad::add_rounds(solid, groups);
  note_large_cells(solid, source, groups.told);
  request.groups = groups.faces;
  request.mesh_size = source.mesh_size;
  request.finer = finer;
  request.mesh = part.mesh;
  SolidMesh result = swept_mesh(part, source, solid, request, groups.told);
  result.told = std::move(groups.told);
  result.told.insert(
      result.told.begin(),
      fmt::format("{}: {}", part.geometry.filename().string(), about(solid)));
  return result;
}

}  // namespace clevis::app
