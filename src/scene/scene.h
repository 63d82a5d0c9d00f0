#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "machine/bearings/bearing.h"
#include "machine/devices/ejector.h"
#include "machine/transmissions/transmission.h"
#include "mechanism/definition/definition.h"
#include "part/geometry_input.h"
#include "part/part_definition.h"
#include "scene/variants/setting.h"
#include "scene/variants/vary_table.h"

namespace clevis::scene {

/// Closed form of [LandingGear] (2.1)–(2.14), as published and corrected,
/// evaluated beside the simulation.
struct SlideLeverClosedForm {
  double FD{}, ED{}, DC{}, EC{}, AD{}, DD1{};  ///< [m]
  int drive{};                                 ///< the drive that gives l_x
  std::string marker;                          ///< the simulated point C
  std::string place;                           ///< file:line:column
};

/// Everything that a scene file says, names resolved, SI.
struct Scene {
  std::filesystem::path file;
  std::string name;
  bool has_mechanism = false;  ///< false: only [[part.case]]
  mechanism::MechanismDefinition mechanism;
  mechanism::SimulationSettings simulation;
  std::vector<machine::BearingDefinition> bearings;
  std::vector<machine::TransmissionDefinition> transmissions;
  std::vector<machine::EjectorDefinition> ejectors;
  std::vector<part::PartDefinition> parts;
  /// What each part gives to its geometry; like `parts`.
  std::vector<part::GeometryInput> inputs;
  double peak_stress_tolerance = 0.01;  ///< [1], relative
  std::optional<SlideLeverClosedForm> slide_lever;
  std::optional<VaryTable> vary;  ///< for `clevis plan`
};

/// Reads and checks a scene file.
/// @param settings  take the place of values of the file.
/// @throws Error S001–S011 with file:line:column or the setting's place, I001.
Scene read_scene(const std::filesystem::path& file,
                 const std::vector<Setting>& settings = {});

/// Content of a scene with its settings, without layout, comments and [vary]:
/// equal for equal scenes, wherever a value comes from. Files of
/// load histories are part of it.
/// @throws Error S001, I001 and those of apply_settings().
std::string scene_content(const std::filesystem::path& file,
                          const std::vector<Setting>& settings);

/// Files that a scene names.
struct NamedFiles {
  std::vector<std::filesystem::path> histories, geometries, meshes;
};

/// The files that the keys of a scene name, as far as they are texts, though
/// the scene be wrong otherwise or they be missing. Meshes that a part names
/// by its geometry alone are not among them.
/// @throws Error S001, I001 and those of apply_settings().
NamedFiles named_files(const std::filesystem::path& file,
                       const std::vector<Setting>& settings);

}  // namespace clevis::scene
