#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.h"

namespace clevis::app {

/// Options that the commands share; each uses those that its help lists.
struct Options {
  std::filesystem::path scene;
  std::vector<std::string> parts;   ///< empty: all
  std::optional<double> tolerance;  ///< of the peak stress, relative [1]
  std::filesystem::path out;        ///< empty: results/<scene>
  bool json = false;                ///< stdout is one JSON document
  bool report = false;              ///< writes report.html too
  std::string model = "auto";       ///< or a word of assessment::kModels
  int jobs = 0;                     ///< parts in parallel; 0: one per core
  std::string elements = "C3D20R";  ///< CalculiX's hexahedra
  int split = 0;                    ///< pieces of each hexahedron's edges; 0:
                                    ///< the command's own
  int modes = 12;                   ///< per part, rigid ones counted in
  bool glb = false;                 ///< a glTF of a result, no decks
  bool every_instant = false;       ///< for CalculiX: a step for each
};

// Each command writes its result to stdout, its progress to stderr, and
// returns the exit code of the process. Refusals are thrown as Error.
ExitCode simulate_command(const Options& options);
ExitCode transmission_command(const Options& options);
ExitCode impact_command(const Options& options);
ExitCode check_command(const Options& options);
ExitCode study_command(const Options& options);
ExitCode export_command(const Options& options);
/// The glTF of a result: `scene` is its folder, or the scene that it is of.
ExitCode glb_command(const Options& options);
ExitCode modes_command(const Options& options);
ExitCode mesh_command(const Options& options);
ExitCode explain_command(const std::string& code);  // empty: list all

struct ReportOptions {
  std::filesystem::path result;  ///< folder of a check or simulation
  std::filesystem::path file;    ///< empty: report.html in it
};
ExitCode report_command(const ReportOptions& options);

struct CompareOptions {
  std::filesystem::path result, baseline;
  std::filesystem::path junit;          ///< empty: none
  std::vector<std::string> tolerances;  ///< "peak_von_mises=0.2%"
  bool json = false;
};
ExitCode compare_command(const CompareOptions& options);

}  // namespace clevis::app
