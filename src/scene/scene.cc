#include "scene/scene.h"

#include <algorithm>
#include <sstream>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "scene/force_elements/read_forces.h"
#include "scene/machine/read_bearings.h"
#include "scene/machine/read_ejectors.h"
#include "scene/machine/read_transmissions.h"
#include "scene/motion/plausible_mechanism.h"
#include "scene/motion/read_drives.h"
#include "scene/motion/read_initial.h"
#include "scene/motion/read_motion.h"
#include "scene/parts/part_names.h"
#include "scene/parts/read_impacts.h"
#include "scene/parts/read_materials.h"
#include "scene/parts/read_parts.h"
#include "scene/parts/read_seats.h"
#include "scene/text/document.h"
#include "scene/text/names.h"
#include "scene/variants/apply_settings.h"
#include "scene/variants/read_vary.h"

namespace clevis::scene {
namespace {

using mechanism::MechanismDefinition;
using mechanism::SpaceDimension;

void require_schema(StrictTable& root) {
  const Value schema = root["schema"];
  constexpr int kLargest = 1'000'000;
  const int version = schema.integer(1, kLargest);
  if (version != 1) {
    throw schema.refusal("S006", fmt::format("= {} is unknown", version),
                         "This clevis reads schema = 1.");
  }
}

MechanismDefinition read_mechanism(StrictTable& root, Names& names) {
  MechanismDefinition mechanism;
  mechanism.bodies = read_bodies(root, names);
  if (mechanism.bodies.empty()) return mechanism;
  mechanism.joints = read_joints(root, mechanism.bodies, names);
  require_plausible(mechanism);
  mechanism.couplings = read_couplings(root, mechanism.joints, names);
  mechanism.drives = read_drives(root, mechanism.joints, names);
  read_forces(root, names, mechanism);
  read_initial_states(root, names, mechanism);
  mechanism.markers = read_markers(root, names);
  mechanism.gravity_W =
      root.table("world")["gravity"].vector(Dimension::kAcceleration);
  if (root.has("mechanism")) {
    StrictTable table = root.table("mechanism");
    if (const auto dimension = table.find("dimension")) {
      mechanism.dimension = dimension->choice<SpaceDimension>(
          {{"auto", SpaceDimension::kAuto},
           {"planar", SpaceDimension::kPlanar},
           {"spatial", SpaceDimension::kSpatial}});
    }
  }
  return mechanism;
}

SlideLeverClosedForm read_slide_lever(StrictTable table, const Names& names) {
  const auto length = [&table](std::string_view key) {
    return table[key].positive(Dimension::kLength);
  };
  SlideLeverClosedForm form;
  form.place = table.place();
  form.FD = length("FD");
  form.ED = length("ED");
  form.DC = length("DC");
  form.EC = length("EC");
  form.AD = length("AD");
  form.DD1 = length("DD1");
  const Value drive = table["drive"];
  form.drive = names.drives.find(drive.name(), drive);
  const Value marker = table["marker"];
  form.marker = marker.name();
  names.markers.find(form.marker, marker);
  return form;
}

void read_parts(std::vector<StrictTable>& tables, const Names& names,
                const std::vector<part::Material>& materials,
                std::vector<ImpactOfPart> impacts, Scene& scene) {
  std::vector<part::PartDefinition>& parts = scene.parts;
  for (StrictTable& table : tables) {
    PartOfGeometry read = read_part(table, names, materials, scene.file);
    parts.push_back(std::move(read.part));
    scene.inputs.push_back(std::move(read.input));
    add_impacts(impacts, static_cast<int>(parts.size()) - 1, parts.back());
    read_seats(table, scene.mechanism, names, parts.back(),
               scene.inputs.back().solid);
  }
  require_own_files(tables, scene.mechanism, parts);
}

double read_peak_stress_tolerance(StrictTable table, double otherwise) {
  const auto value = table.find("peak_stress");
  if (!value) return otherwise;
  const double tolerance = value->quantity(Dimension::kRatio);
  if (!(1e-5 <= tolerance && tolerance <= 0.5)) {
    throw value->refusal("S006", "is out of range",
                         "Give a tolerance from 0.001 % to 50 %.");
  }
  return tolerance;
}

/// Links give way by what their parts' meshes say.
/// @throws Error S010.
void require_elastic_links(StrictTable& root, const Scene& scene) {
  if (scene.simulation.links != mechanism::LinkStiffness::kElastic) return;
  if (std::ranges::any_of(scene.mechanism.bodies, [](const auto& body) {
        return !body.part.empty();
      })) {
    return;
  }
  throw root.table("simulation")["links"].refusal(
      "S010", "= \"elastic\", but no body has a part",
      "Give bodies their `part`, or joints their `compliance`.");
}

/// Gas that communicates once in a motion does not move it; what does a million
/// times takes hours.
/// @throws Error S006.
void require_sensible_steps(const Scene& scene) {
  constexpr double kFewest = 10.0, kMost = 1e6;
  for (const auto& element : scene.mechanism.elements) {
    const auto* gas = mechanism::properties(element).gas;
    if (gas == nullptr || !gas->is_coupled()) continue;
    const double exchanges = scene.simulation.duration / gas->step;
    if (kFewest <= exchanges && exchanges <= kMost) continue;
    throw Error("S006", mechanism::place_of(element),
                fmt::format("gas_cylinder \"{}\" communicates {:.3g} times in "
                            "the motion, by the `step` of its coupling",
                            mechanism::name_of(element), exchanges),
                "Give a step from a millionth to a tenth of the duration.");
  }
}

Document document_with(const std::filesystem::path& file,
                       const std::vector<Setting>& settings) {
  Document document = read_document(file);
  apply_settings(settings, document.root);
  return document;
}

std::vector<const toml::table*> tables_of(const toml::table& table,
                                          std::string_view key) {
  std::vector<const toml::table*> found;
  const toml::array* array = table[key].as_array();
  if (array == nullptr) return found;
  for (const toml::node& node : *array) {
    if (node.is_table()) found.push_back(node.as_table());
  }
  return found;
}

/// As the scene writes them.
NamedFiles files_named_by(const toml::table& root) {
  NamedFiles files;
  const auto add = [](const toml::table& table, std::string_view key,
                      std::vector<std::filesystem::path>& names) {
    if (const auto name = table[key].value<std::string>()) {
      names.emplace_back(*name);
    }
  };
  for (const toml::table* part : tables_of(root, "part")) {
    add(*part, "geometry", files.geometries);
    add(*part, "mesh", files.meshes);
    for (const toml::table* history : tables_of(*part, "history")) {
      add(*history, "file", files.histories);
    }
  }
  return files;
}

}  // namespace

NamedFiles named_files(const std::filesystem::path& file,
                       const std::vector<Setting>& settings) {
  NamedFiles files = files_named_by(document_with(file, settings).root);
  for (auto* names : {&files.histories, &files.geometries, &files.meshes}) {
    for (std::filesystem::path& name : *names) name = file.parent_path() / name;
  }
  return files;
}

std::string scene_content(const std::filesystem::path& file,
                          const std::vector<Setting>& settings) {
  Document document = document_with(file, settings);
  document.root.erase("vary");
  std::ostringstream text;
  text << toml::toml_formatter(document.root);
  for (const auto& history : files_named_by(document.root).histories) {
    text << '\n' << read_text(file.parent_path() / history);
  }
  return text.str();
}

Scene read_scene(const std::filesystem::path& file,
                 const std::vector<Setting>& settings) {
  const Document document = document_with(file, settings);
  StrictTable root(Value(document.root, "scene", document.file), "");
  require_schema(root);
  Scene scene;
  scene.file = file;
  scene.name = root["name"].text();

  Names names;
  const auto materials = read_materials(root, names);
  auto part_tables = root.tables("part");
  for (StrictTable& table : part_tables) {
    const Value name = table["name"];
    names.parts.add(name.name(), name);
  }
  scene.mechanism = read_mechanism(root, names);
  scene.has_mechanism = !scene.mechanism.bodies.empty();
  scene.transmissions = read_transmissions(root, names);
  scene.ejectors = read_ejectors(root, materials, names);
  if (!scene.has_mechanism && part_tables.empty() &&
      scene.transmissions.empty() && scene.ejectors.empty()) {
    throw root.refusal("S003", "has neither [[body]] nor [[part]]",
                       "Add a mechanism, a part with cases, or both.");
  }
  read_parts(part_tables, names, materials,
             read_impacts(root, scene.mechanism, names), scene);
  if (scene.has_mechanism) {
    scene.simulation = read_simulation(root.table("simulation"));
    require_elastic_links(root, scene);
    require_sensible_steps(scene);
    scene.bearings = read_bearings(root, scene.mechanism.joints, names);
  }
  if (root.has("accuracy")) {
    scene.peak_stress_tolerance = read_peak_stress_tolerance(
        root.table("accuracy"), scene.peak_stress_tolerance);
  }
  if (scene.has_mechanism && root.has("closed_form")) {
    StrictTable closed_form = root.table("closed_form");
    if (closed_form.has("slide_lever")) {
      scene.slide_lever =
          read_slide_lever(closed_form.table("slide_lever"), names);
    }
  }
  if (root.has("vary")) scene.vary = read_vary(root.table("vary"));
  root.finish("without any [[body]]");
  return scene;
}

}  // namespace clevis::scene
