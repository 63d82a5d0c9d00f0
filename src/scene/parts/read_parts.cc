#include "scene/parts/read_parts.h"

#include <fmt/format.h>

#include "base/bytes/fingerprint.h"
#include "scene/cases/read_cases.h"
#include "scene/cases/read_histories.h"
#include "scene/parts/read_parameters.h"
#include "scene/solids/read_faces.h"
#include "scene/text/names.h"

namespace clevis::scene {
namespace {

/// meshes/NAME/part.msh for a scene in geometry/NAME, else beside the
/// geometry. Each set of parameters has a mesh of its own, part-HASH.msh, and
/// each part of a solid, whose groups are its own, FILE-PART.msh.
std::filesystem::path mesh_of_geometry(
    const std::filesystem::path& geometry,
    const std::vector<part::GeometryParameter>& parameters,
    const std::string& part_name, const std::filesystem::path& file) {
  auto folder = std::filesystem::absolute(file).lexically_normal();
  folder = folder.parent_path();
  if (geometry.is_relative() && folder.parent_path().filename() == "geometry") {
    folder = folder.parent_path().parent_path() / "meshes" / folder.filename();
  }
  auto name = geometry.stem();
  if (!parameters.empty()) {
    name += fmt::format("-{}", fingerprint(part::text_of(parameters)));
  }
  if (part::is_solid_file(geometry) && geometry.stem() != part_name) {
    name += "-" + part_name;
  }
  name += ".msh";
  return (folder / geometry)
      .replace_filename(name)
      .lexically_normal()
      .lexically_proximate(std::filesystem::current_path());
}

double read_length_unit(const Value& value) {
  try {
    return parse_quantity("1 " + value.text(), Dimension::kLength,
                          value.place());
  } catch (const Error&) {
    throw value.refusal(
        "S004", fmt::format("= \"{:.60}\" is no unit of length", value.text()),
        "Give the unit of the mesh's coordinates alone, e.g. "
        "\"mm\".");
  }
}

/// STEP and IGES files have units of their own, a BREP has none.
void read_length_unit_of(StrictTable& table, part::GeometryFormat format,
                         part::PartDefinition& part, part::SolidSource& solid) {
  using enum part::GeometryFormat;
  if (format == kScript) {
    part.length_unit = read_length_unit(table["length_unit"]);
    return;
  }
  part.length_unit = part::kSolidMeshUnit;
  if (format == kBrep) {
    solid.length_unit = read_length_unit(table["length_unit"]);
  } else if (const auto unit = table.find("length_unit")) {
    throw unit->refusal("S010", "stands beside a file that has its own unit",
                        "Leave it out: `clevis faces` prints the file's unit.");
  }
}

/// Pieces of a cell along each direction. @throws Error S010.
int read_refine(StrictTable& table, bool is_solid) {
  constexpr int kMost = 16;
  const auto refine = table.find("refine");
  if (!refine) return 1;
  if (is_solid) {
    throw refine->refusal("S010",
                          "is for hexahedra, but a solid is meshed anew",
                          "Give `mesh_size` instead.");
  }
  return refine->integer(1, kMost);
}

/// What only a solid of a CAD system takes. @throws Error S010.
void read_solid(StrictTable& table, bool is_solid, part::SolidSource& solid) {
  for (const std::string_view key : {"faces", "mesh_size", "sweep"}) {
    if (is_solid || !table.has(key)) continue;
    throw table[key].refusal(
        "S010", "is for a solid, but `geometry` is no STEP, IGES or BREP file",
        "Name groups and sizes in the .geo or the mesh.");
  }
  if (const auto faces = table.find("faces")) {
    solid.faces = read_faces(*faces);
  }
  if (const auto size = table.find("mesh_size")) {
    solid.mesh_size = size->positive(Dimension::kLength);
    solid.mesh_size_place = size->place();
  }
  if (const auto sweep = table.find("sweep")) {
    solid.sweep = sweep->choice<bool>({{"auto", true}, {"never", false}});
  }
}

part::Limits read_limits(StrictTable table) {
  constexpr double kLargestFactor = 1000.0;
  part::Limits limits;
  if (const auto factor = table.find("safety_factor")) {
    const auto& node = factor->node();
    const double wanted = node.is_number() ? *node.value<double>() : 0.0;
    if (0.0 < wanted && wanted < 1.0) {
      throw factor->refusal(
          "S006",
          fmt::format("= {} lets the part yield, where linear elasticity says "
                      "nothing of it",
                      wanted),
          "Give a factor from 1 to 1000, on the yield strength.");
    }
    limits.safety_factor = factor->number(1.0, kLargestFactor);
  }
  if (const auto deflection = table.find("deflection")) {
    limits.deflection = deflection->positive(Dimension::kLength);
  }
  if (const auto factor = table.find("buckling")) {
    limits.buckling = factor->number(1.0, kLargestFactor);
  }
  if (const auto zones = table.find("singular_zones")) {
    limits.exclude_singular_zones =
        zones->choice<bool>({{"count", false}, {"exclude", true}});
  }
  return limits;
}

/// Where it is not named, the scene's only one.
const part::Material& material_of(
    StrictTable& table, const Names& names,
    const std::vector<part::Material>& materials) {
  if (!table.has("material") && materials.size() == 1) return materials.front();
  const Value material = table["material"];
  return materials[static_cast<std::size_t>(
      names.materials.find(material.name(), material))];
}

}  // namespace

PartOfGeometry read_part(StrictTable& table, const Names& names,
                         const std::vector<part::Material>& materials,
                         const std::filesystem::path& file) {
  PartOfGeometry result;
  part::PartDefinition& part = result.part;
  part.name = table["name"].name();
  part.place = table.place();
  const auto geometry = table.find("geometry");
  const auto mesh = table.find("mesh");
  if (!geometry && !mesh) {
    throw table.refusal("S003", "lacks the key \"mesh\" or \"geometry\"",
                        "Give a .msh file, or the .geo or STEP file that it is "
                        "made of.");
  }
  if (geometry) part.geometry = file.parent_path() / geometry->text();
  const auto format = part::geometry_format(part.geometry);
  const bool is_solid = format != part::GeometryFormat::kScript;
  read_length_unit_of(table, format, part, result.input.solid);
  read_solid(table, is_solid, result.input.solid);
  result.input.refine = read_refine(table, is_solid);
  if (const auto parameters = table.find("parameters")) {
    if (!geometry || mesh || is_solid) {
      throw parameters->refusal(
          "S010",
          geometry && mesh
              ? "stands beside `mesh`, which is one mesh for all of them"
              : "are those of a .geo, but the part has no such `geometry`",
          "Give a .geo as `geometry` alone: each set of parameters has its own "
          "mesh.");
    }
    result.input.parameters = read_parameters(*parameters, part.length_unit);
  }
  part.mesh = mesh ? file.parent_path() / mesh->text()
                   : mesh_of_geometry(geometry->text(), result.input.parameters,
                                      part.name, file);
  if (const auto thickness = table.find("thickness")) {
    part.thickness = thickness->positive(Dimension::kLength);
  }
  part.material = material_of(table, names, materials);
  if (table.has("limits")) part.limits = read_limits(table.table("limits"));
  if (const auto damping = table.find("damping")) {
    constexpr double kLargestDamping = 0.5;
    part.damping = damping->number(0.0, kLargestDamping);
  }
  if (const auto joints = table.find("joints")) {
    part.ideal_joints =
        joints->choice<bool>({{"yielding", false}, {"ideal", true}});
  }
  NameIndex cases("case");
  for (StrictTable& entry : table.tables("case")) {
    const Value name = entry["name"];
    cases.add(name.title(), name);
    part.cases.push_back(read_case(entry));
  }
  part.series = read_histories(table, file);
  return result;
}

}  // namespace clevis::scene
