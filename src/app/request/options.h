#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/variants/setting.h"

namespace clevis::app {

/// Options that the commands share; each uses those that its help lists.
struct Options {
  std::filesystem::path scene;
  std::vector<scene::Setting> settings;  ///< in place of the scene's values
  std::vector<std::string> parts;        ///< empty: all
  std::optional<double> tolerance;       ///< of the peak stress, relative [1]
  std::filesystem::path out;             ///< empty: results/<scene>
  bool json = false;                     ///< stdout is one JSON document
  bool report = false;                   ///< writes report.html too
  bool glb = false;                      ///< a glTF of a result, no decks
  bool linear_vtu = false;  ///< fields in linear cells beside those of degree p
  std::string model = "auto";   ///< or a word of assessment::kModels
  std::string engine = "auto";  ///< or a word of elasticity::kEngineWords
  bool mesh = false;            ///< make outdated meshes first
  int mesh_rounds = 2;          ///< finer meshes of a solid at most
  bool watch = false;           ///< check again when files change
  /// Of a watched check: the number of this run, which its report bears.
  std::optional<int> watch_run = {};
  bool resume = false;              ///< keep a finished result of these inputs
  std::optional<double> max_time;   ///< of the processor, for a motion [s]
  std::optional<int> max_dofs;      ///< of a part's solution; none: memory's
  int jobs = 0;                     ///< parts in parallel; 0: one per core
  std::string elements = "C3D20R";  ///< CalculiX's hexahedra
  int split = 0;                    ///< pieces of each hexahedron's edges; 0:
                                    ///< the command's own
  int modes = 12;                   ///< per part, rigid ones counted in
  bool every_instant = false;       ///< for CalculiX: a step for each
};

/// Options of `clevis plan`.
struct PlanOptions {
  std::string program;  ///< as the user called it, for the commands
  std::filesystem::path scene;
  std::filesystem::path vary;  ///< CSV of variants; empty: the scene's [vary]
  std::filesystem::path out;   ///< empty: results/<scene>_variants
  std::vector<std::string> parts;
  std::string tolerance_text;       ///< as given, e.g. "20%"; empty: none
  std::optional<double> tolerance;  ///< the same, relative [1]
  std::string model = "auto";
  int jobs = 1;
};

/// Options of `clevis faces`.
struct FacesOptions {
  std::filesystem::path file;     ///< of a solid, or a scene
  std::string part;               ///< of the scene; empty: all that are solids
  std::filesystem::path picture;  ///< .svg or .png to write; empty: none
  bool json = false;
};

/// Options of `clevis report`.
struct ReportOptions {
  std::filesystem::path result;  ///< folder of a check or simulation
  std::filesystem::path file;    ///< empty: report.html in it
};

/// Options of `clevis compare`.
struct CompareOptions {
  std::filesystem::path result, baseline;
  std::filesystem::path junit;          ///< empty: none
  std::vector<std::string> tolerances;  ///< "peak_von_mises=0.2%"
  bool json = false;
};

}  // namespace clevis::app
