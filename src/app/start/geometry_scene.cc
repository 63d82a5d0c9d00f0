#include "app/start/geometry_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/solids/solid_mesh.h"
#include "app/solids/solid_mesher.h"
#include "app/start/first_case_text.h"
#include "base/messages/errors.h"
#include "cad/first_case.h"
#include "cad/pin_bores.h"
#include "cad/plate.h"
#include "cad/selector_choice.h"
#include "multibody/names.h"
#include "part/solid_source.h"
#include "report/text/atomic_file.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::size_t kMostBores = 8;  // that are listed

constexpr std::string_view kMaterial =
    R"(# Structural steel S355. Put in the numbers of your own.
[material]
steel = { youngs_modulus = "210 GPa", poissons_ratio = 0.3, density = "7850 kg/m^3", yield_strength = "355 MPa" }

)";

constexpr std::string_view kLimits =
    R"(# The peak stress may reach yield_strength / safety_factor.
# A limit of the deflection can stand beside it: deflection = "0.1 mm".
# A sharp inner corner has no finite stress, so the part is not judged: round it
# in the CAD file, or judge the rest by singular_zones = "exclude" beside it.
limits = { safety_factor = 1.5 }

)";

/// For comments and terminals: other characters become "?".
std::string plain(std::string text) {
  std::ranges::replace_if(
      text,
      [](char c) {
        return c < ' ' || c > '~';
      },
      '?');
  return text;
}

/// Six digits, to a thousandth of `size` or finer; what rounds to zero is 0.
std::string rounded(double value, double size) {
  constexpr double kOfSize = 1e-3;
  const double step = std::pow(10.0, std::floor(std::log10(kOfSize * size)));
  return fmt::format("{:.6g}", std::round(value / step) * step + 0.0);
}

/// "diameter 16 mm, 18 mm long in 2 pieces, middle (40, 0, 0) mm, axis
/// (0, 0, 1)"; with a keyway "16 mm long, 93 % of its wall, …".
std::string about_bore(const cad::PinBore& bore) {
  const double diameter = 1e3 * bore.diameter;  // [mm]
  const auto text = [&](double length) {
    return rounded(1e3 * length, diameter);
  };
  const Vector3d& p = bore.middle;
  const std::size_t n = bore.pieces.size();
  return fmt::format(
      "diameter {:.6g} mm, {} mm long{}{}, middle ({}, {}, {}) mm, axis ({})",
      diameter, text(bore.length), n > 1 ? fmt::format(" in {} pieces", n) : "",
      bore.is_whole()
          ? ""
          : fmt::format(", {:.3g} % of its wall", 100.0 * bore.share()),
      text(p.x()), text(p.y()), text(p.z()), cad::components(bore.axis));
}

/// A group of [part.faces].
struct Named {
  std::string group, about;
  cad::SelectorChoice choice;
  bool is_used{};  ///< by the case; others stand in comments
};

std::vector<Named> named_faces(const cad::Solid& solid,
                               const cad::FirstCase& made) {
  std::vector<Named> named;
  for (std::size_t i = 0; i < std::min(made.bores.size(), kMostBores); ++i) {
    named.push_back({bore_name(i), about_bore(made.bores[i]),
                     cad::choice_of(made.bores[i]),
                     made.held == i || made.pulled == i});
  }
  const auto add_plane = [&](const char* group, std::optional<int> number) {
    if (!number) return;
    const auto face =
        std::ranges::find(solid.faces, *number, &cad::Face::number);
    named.push_back({group, fmt::format("plane, {:.6g} mm^2", 1e6 * face->area),
                     cad::choice_of(*face), true});
  };
  add_plane(kBase, made.base);
  add_plane(kEnd, made.end);
  return named;
}

std::vector<Vector3d> points_of(const std::vector<Named>& all) {
  std::vector<cad::SelectorChoice> choices;
  for (const Named& named : all) choices.push_back(named.choice);
  return cad::points_of(choices);
}

[[noreturn]] void refuse(const Named& named, const fs::path& file) {
  throw Error("M017", file.string(),
              fmt::format("no selector tells the face of {} ({}) from others",
                          named.group, named.about),
              "Give it a name in the CAD system, which `clevis faces` shows as "
              "a label, and write the scene with { label = \"NAME\" }.");
}

/// Of bores that a user may miss in the scene, a line each.
std::vector<std::string> left_out(const cad::Solid& solid) {
  const auto open = cad::open_bores(solid);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(open.size(), kMostBores); ++i) {
    lines.push_back(
        fmt::format("left out, for a pin needs most of a wall and here are "
                    "{:.3g} % of one: {}",
                    100.0 * open[i].share(), cad::list_of(open[i].pieces)));
  }
  if (open.size() > kMostBores) {
    lines.push_back(
        fmt::format("left out: {} more of its kind", open.size() - kMostBores));
  }
  if (!open.empty()) {
    lines.push_back("hold these by `foundation`, load them by `traction`");
  }
  return lines;
}

/// @param solid  with the distances of the groups' points.
/// @throws Error M017 if a face that the case needs cannot be told from others.
std::string faces_text(const cad::Solid& solid, const std::vector<Named>& all,
                       const fs::path& file) {
  const std::vector<Vector3d> points = points_of(all);
  std::string lines, unused;
  for (const Named& named : all) {
    const auto selector = cad::chosen(solid, points, named.choice);
    if (!selector && named.is_used) refuse(named, file);
    if (!selector) continue;
    if (!named.is_used)
      unused = "# Those that the case does not need stand in comments.\n";
    lines += fmt::format("# {}: {}\n{}{} = {}\n", named.group, named.about,
                         named.is_used ? "" : "# ", named.group,
                         cad::toml_text(*selector));
  }
  return unused + "[part.faces]\n" + lines;
}

std::string scene_text(const GeometryScene& made, const cad::Solid& solid) {
  const auto plate = cad::plate_of(solid);
  return fmt::format(
             "# {} alone: what it is, how it is held, what loads it.\n"
             "# Read as: {}.\n{}"
             "# Does it hold?         clevis check scene.toml\n"
             "# Which face is which?  clevis faces scene.toml --picture "
             "faces.svg\n"
             "schema = 1\nname = \"{}\"\n\n",
             made.file, plain(about(solid)),
             plate ? "# It is " + cad::text(*plate) + ".\n" : "", made.part) +
         std::string(kMaterial);
}

std::string part_text(const GeometryScene& made) {
  const bool has_unit =
      part::geometry_format(made.file) != part::GeometryFormat::kBrep;
  return fmt::format(
             "[[part]]\nname = \"{}\"\ngeometry = \"{}\"  # a copy: put a "
             "changed file here again\n{}",
             made.part, made.file,
             has_unit
                 ? ""
                 : "length_unit = \"mm\"  # a BREP does not say its own\n") +
         std::string(kLimits);
}

/// Names that a scene takes, of those of a file.
GeometryScene named_after(const fs::path& file) {
  std::vector<std::string> ignored;
  GeometryScene made;
  made.part = multibody::Names("part", {"mechanism"})
                  .add(file.stem().string(), ignored);
  made.file = file.filename().string();
  if (!report::is_file_name(made.file)) {
    made.file = made.part + file.extension().string();
  }
  return made;
}

}  // namespace

GeometryScene geometry_scene(const fs::path& file) {
  if (!part::is_solid_file(file)) {
    throw Error("M015", file.string(),
                "is no STEP, IGES or BREP file by its name",
                "Export the part as STEP (.step, .stp), IGES (.iges, .igs) or "
                "BREP (.brep); for gmsh's .geo and .msh `clevis init NAME` "
                "writes a scene to start from.");
  }
  cad::Request request;
  request.file = file;
  request.length_unit = part::kSolidMeshUnit;  // of a BREP, which has none
  const cad::Solid solid = run_mesher(request).solid;
  const cad::FirstCase first = cad::first_case(solid, file.string());
  const std::vector<Named> named = named_faces(solid, first);
  request.points = points_of(named);
  const cad::Solid measured = run_mesher(request).solid;

  const FirstCaseText text = first_case_text(first);
  const std::size_t n_bores = first.bores.size();
  const std::vector<std::string> missed = left_out(solid);
  GeometryScene made = named_after(file);
  made.text =
      scene_text(made, solid) + part_text(made) +
      (n_bores > 0 ? "# Its bores, the widest first, in the file's frame.\n"
                   : "# Two of its faces, in the file's frame.\n") +
      faces_text(measured, named, file) +
      (n_bores > kMostBores
           ? fmt::format("# and {} more bores: clevis faces {}\n",
                         n_bores - kMostBores, made.file)
           : "") +
      (missed.empty() ? "" : fmt::format("# {}\n", fmt::join(missed, "\n# "))) +
      "\n" + text.toml;
  made.told = fmt::format("{} alone, {}\n  {}", made.file, text.about,
                          plain(about(solid)));
  for (const std::string& line : missed) made.told.append("\n  ").append(line);
  return made;
}

}  // namespace clevis::app
