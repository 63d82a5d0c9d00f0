#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace clevis::app {

/// Runs a command with the options that its command line gave.
using Run = std::function<ExitCode()>;

/// Options of a command with a scene, and texts among them that are read when
/// the whole command line stands.
struct SceneRequest {
  Options options;
  std::vector<std::string> settings;     ///< PATH=VALUE
  std::optional<std::string> tolerance;  ///< e.g. "1%"
  std::optional<std::string> max_time;   ///< e.g. "10 min"
};

// Options that several commands share. What they fill in must live as long as
// the parser.

/// An option that is given once for each value.
CLI::Option* repeatable(CLI::Option* option, const std::string& type_name);
/// SCENE and --set.
void add_scene(CLI::App& command, SceneRequest& request);
void add_parts(CLI::App& command, std::vector<std::string>& parts);
void add_jobs(CLI::App& command, int& jobs, const char* help);
/// --out and --json.
void add_output(CLI::App& command, Options& options);
void add_report_flag(CLI::App& command, Options& options);
void add_mesh_flag(CLI::App& command, Options& options);
void add_max_time(CLI::App& command, SceneRequest& request);
void add_max_dofs(CLI::App& command, Options& options, const char* help);
void add_engine(CLI::App& command, Options& options);
void add_model(CLI::App& command, std::string& model);
/// CalculiX's kind of cells.
void add_elements(CLI::App& command, Options& options);
void add_split(CLI::App& command, Options& options, const char* help);

/// Relative tolerance of the peak stress [1] from e.g. "1%"; a bare number may
/// be meant either way.
/// @throws Error U001 beyond 0.001% to 50%.
double peak_tolerance(const std::string& text);

/// Reads the texts of a request, then runs its command.
Run run_request(std::shared_ptr<SceneRequest> request,
                ExitCode (*command)(const Options&));

}  // namespace clevis::app
