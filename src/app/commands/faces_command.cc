#include "app/commands/faces_command.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/solids/face_picture.h"
#include "app/solids/solid_mesh.h"
#include "app/solids/solid_mesher.h"
#include "base/messages/errors.h"
#include "cad/face_groups.h"
#include "cad/select_faces.h"
#include "cad/selector_choice.h"
#include "report/text/json_text.h"
#include "report/text/terminal.h"
#include "report/text/text_table.h"
#include "scene/scene.h"

namespace clevis::app {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;

/// A solid to print, and what the scene asks of it.
struct Asked {
  std::string name;  ///< part, or the file
  std::filesystem::path file;
  part::SolidSource source;
};

/// What was found; the groups fail apart from the faces.
struct Found {
  std::string name, file;
  cad::Solid solid;
  cad::FaceGroups groups;
  std::optional<Error> refused;

  std::string group_of(int face) const {
    for (const auto& [group, faces] : groups.faces) {
      if (std::ranges::find(faces, face) != faces.end()) return group;
    }
    return {};
  }
};

std::vector<Asked> parts_of_scene(const FacesOptions& options) {
  const scene::Scene scene = scene::read_scene(options.file);
  std::vector<Asked> asked;
  std::vector<std::string_view> solids;
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    const auto& part = scene.parts[p];
    if (!part::is_solid_file(part.geometry)) continue;
    solids.push_back(part.name);
    if (!options.part.empty() && options.part != part.name) continue;
    asked.push_back({part.name, part.geometry, scene.inputs[p].solid});
  }
  if (!asked.empty()) return asked;
  if (solids.empty()) {
    throw Error("S003", options.file.string() + ":1:1",
                "no part of the scene is a STEP, IGES or BREP solid",
                "Give a part such a file as `geometry`, or print the file "
                "itself.");
  }
  throw Error(
      "U001", "PART",
      fmt::format("the scene has no solid of the name \"{}\"", options.part),
      fmt::format("Its solids: {}.", fmt::join(solids, ", ")));
}

/// @param facets  whether triangles of the faces are wanted.
Found find(const Asked& asked, bool facets) {
  cad::Request request;
  request.facets = facets;
  request.file = asked.file;
  request.length_unit = asked.source.length_unit;
  request.points = cad::points_of(asked.source);
  Found found{
      asked.name, asked.file.string(), run_mesher(request).solid, {}, {}};
  try {
    found.groups = cad::face_groups(found.solid, request.points, asked.source);
  } catch (const Error& error) {
    found.refused = error;
  }
  return found;
}

/// What rounds to zero is 0, without a sign.
std::string number(double value) {
  constexpr double kFinest = 1e6;
  return fmt::format("{:.6g}", std::round(kFinest * value) / kFinest + 0.0);
}

/// Nine digits: a mechanism whose joints are copied from here closes.
std::string vector(const Vector3d& v) {
  return "(" + cad::components(v) + ")";
}

std::string type_of(const cad::Face& face) {
  const auto name =
      std::ranges::find(cad::kSurfaceNames, face.kind,
                        &std::pair<std::string_view, cad::SurfaceKind>::second);
  return fmt::format("{}{}", face.hollow ? "hollow " : "", name->first);
}

report::TextTable table_of(const Found& found) {
  using enum report::Align;
  const bool has_labels =
      std::ranges::any_of(found.solid.faces, [](const cad::Face& face) {
        return !face.label.empty();
      });
  std::vector<report::TextTable::Column> columns{
      {"face", kRight},      {"type"},       {"diameter mm", kRight},
      {"length mm", kRight}, {"centre mm"},  {"axis or normal"},
      {"area mm2", kRight},  {"neighbours"}, {"group"}};
  if (has_labels) columns.push_back({"label"});
  report::TextTable table(columns);
  for (const cad::Face& face : found.solid.faces) {
    const bool is_round = face.radius > 0.0;
    const double length = 1e3 * (face.high - face.low);
    const bool has_axis = face.axis.norm() > 0.0;
    std::vector<report::TextTable::Cell> cells{
        {std::to_string(face.number)},
        {type_of(face)},
        {is_round ? number(2e3 * face.radius) : ""},
        {length > 0.0 ? number(length) : ""},
        {vector(1e3 * face.centre)},
        {vector(has_axis ? face.axis : face.normal)},
        {number(1e6 * face.area)},
        {fmt::format("{}", fmt::join(face.neighbours, " "))},
        {found.group_of(face.number)}};
    if (has_labels) cells.push_back({face.label});
    table.add_row(cells);
  }
  for (const std::string& line : found.groups.told) table.add_note(line);
  return table;
}

ordered_json vector_json(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

ordered_json face_json(const Found& found, const cad::Face& face) {
  ordered_json json{{"number", face.number},
                    {"type", type_of(face)},
                    {"area_m2", face.area},
                    {"centre_m", vector_json(face.centre)},
                    {"neighbours", face.neighbours}};
  if (face.radius > 0.0) json["diameter_m"] = 2 * face.radius;
  if (face.high > face.low) json["length_m"] = face.high - face.low;
  if (face.axis.norm() > 0.0) {
    json["axis"] = vector_json(face.axis);
    json["axis_point_m"] = vector_json(face.axis_point);
  }
  json["normal"] = vector_json(face.normal);
  if (!face.label.empty()) json["label"] = face.label;
  const std::string group = found.group_of(face.number);
  if (!group.empty()) json["group"] = group;
  return json;
}

ordered_json json_of(const Found& found) {
  ordered_json faces = ordered_json::array();
  for (const cad::Face& face : found.solid.faces) {
    faces.push_back(face_json(found, face));
  }
  return {{"name", found.name},
          {"file", found.file},
          {"unit", found.solid.unit},
          {"volume_m3", found.solid.volume},
          {"low_m", vector_json(found.solid.low)},
          {"high_m", vector_json(found.solid.high)},
          {"faces", faces}};
}

/// @throws Error U001 if a picture is asked for of several parts.
void require_one(const std::vector<Asked>& asked, const FacesOptions& options) {
  if (options.picture.empty() || asked.size() == 1) return;
  std::vector<std::string> names;
  for (const Asked& one : asked) names.push_back(one.name);
  throw Error(
      "U001", "--picture",
      fmt::format("the scene has {} solids, a picture shows one", asked.size()),
      fmt::format("Name the part behind the scene: {}.",
                  fmt::join(names, " or ")));
}

/// Tells where the picture lies, and what it does not show, on stderr: stdout
/// may be JSON.
void draw(const Found& found, const std::filesystem::path& file) {
  const auto hidden = write_face_picture(
      found.solid,
      [&found](int face) {
        return found.group_of(face);
      },
      fmt::format("{}: {} faces", found.name, found.solid.faces.size()), file);
  std::cerr << "picture: " << file.string() << "\n";
  if (!hidden.empty()) {
    std::cerr << fmt::format("no view shows the faces {}\n",
                             fmt::join(hidden, " "));
  }
}

}  // namespace

ExitCode faces_command(const FacesOptions& options) {
  if (!options.picture.empty()) require_picture_name(options.picture);
  std::vector<Asked> asked;
  if (part::is_solid_file(options.file)) {
    // A BREP has no unit; OpenCASCADE's own is the millimetre.
    part::SolidSource source;
    source.length_unit = part::kSolidMeshUnit;
    asked = {{options.file.filename().string(), options.file, source}};
  } else {
    asked = parts_of_scene(options);
  }
  require_one(asked, options);
  std::vector<Found> all;
  for (const Asked& one : asked) {
    all.push_back(find(one, !options.picture.empty()));
  }
  if (!options.picture.empty()) draw(all.front(), options.picture);
  const auto refused = std::ranges::find_if(all, [](const Found& found) {
    return found.refused.has_value();
  });
  if (options.json) {
    if (refused != all.end()) throw Error(*refused->refused);
    ordered_json solids = ordered_json::array();
    for (const Found& found : all) solids.push_back(json_of(found));
    std::cout << report::json_text(
        {{"schema", report::kSchema}, {"solids", solids}});
    return ExitCode::kPass;
  }
  for (const Found& found : all) {
    std::cout << fmt::format(
        "{}: {}\n{}\n", found.name, about(found.solid),
        table_of(found).text(report::colour_of(STDOUT_FILENO)));
  }
  if (refused != all.end()) throw Error(*refused->refused);
  return ExitCode::kPass;
}

Run declare_faces(CLI::App& command) {
  command.footer(
      "Number, type, diameter, place, axis or normal, area and neighbours of "
      "every\nface; of a scene's parts also the groups that joints and "
      "selectors find.");
  const auto options = std::make_shared<FacesOptions>();
  command
      .add_option("FILE", options->file,
                  "a .step, .stp, .iges, .igs or .brep file, or a scene")
      ->required();
  command.add_option("PART", options->part,
                     "of the scene; default: all parts that are solids");
  command
      .add_option("--picture", options->picture,
                  "draw the solid from several sides with its faces' numbers: "
                  "*.svg or *.png")
      ->type_name("FILE");
  command.add_flag("--json", options->json,
                   "print one JSON document instead of tables");
  return [options] {
    return faces_command(*options);
  };
}

}  // namespace clevis::app
