#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace clevis::app {

/// Options that the commands share; each uses those that its help lists.
struct Options {
  std::filesystem::path scene;
  std::vector<std::string> parts;   ///< empty: all
  std::optional<double> tolerance;  ///< of the peak stress, relative [1]
  std::filesystem::path out;        ///< empty: results/<scene>
  bool json = false;                ///< stdout is one JSON document
  std::string model = "auto";       ///< or a word of assessment::kModels
  std::string engine = "auto";      ///< or a word of elasticity::kEngineWords
  int jobs = 0;                     ///< parts in parallel; 0: one per core
  std::string elements = "C3D20R";  ///< CalculiX's hexahedra
  int split = 0;                    ///< pieces of each hexahedron's edges; 0:
                                    ///< the command's own
  int modes = 12;                   ///< per part, rigid ones counted in
  bool every_instant = false;       ///< for CalculiX: a step for each
};

/// Options of `clevis compare`.
struct CompareOptions {
  std::filesystem::path result, baseline;
  std::filesystem::path junit;          ///< empty: none
  std::vector<std::string> tolerances;  ///< "peak_von_mises=0.2%"
  bool json = false;
};

}  // namespace clevis::app
