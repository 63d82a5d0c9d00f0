#include "app/start/doctor_command.h"

#include <chrono>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <tuple>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "app/companions/model_importer.h"
#include "app/companions/sandbox.h"
#include "app/plugin/solver_library.h"
#include "app/processes/child_process.h"
#include "app/processes/temporary_folder.h"
#include "app/solids/solid_mesher.h"
#include "base/system/companion.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

/// A program that clevis runs.
struct Tool {
  const char* name;
  const char* version_option;
  const char* needed_for;
};

constexpr Tool kTools[] = {
    {"gmsh", "--version", "clevis mesh, check --mesh"},
    {"ccx", "-v", "clevis study: CalculiX beside clevis"},
    {"gnuplot", "--version", "clevis study, collect: plots"},
    {"mpirun", "--version", "mpirun clevis check: large parts"}};

/// The first line with a digit of what a program says of its version.
std::string version_line(const fs::path& log) {
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_of("0123456789") != std::string::npos) return line;
  }
  return "found";
}

std::string version(const Tool& tool) {
  const TemporaryFolder folder;
  const fs::path log = folder.path() / "version.txt";
  const ChildOutcome outcome =
      run_child({.arguments = {tool.name, tool.version_option},
                 .folder = folder.path(),
                 .log = log},
                std::chrono::seconds(10));
  return outcome.was_found() ? version_line(log) : "not found";
}

void print(const char* name, const std::string& found, const char* needed_for) {
  std::cout << fmt::format("{:<15} {:<44} {}\n", name, found, needed_for);
}

double memory_GiB() {
  constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGESIZE)) / kGiB;
}

}  // namespace

ExitCode doctor_command() {
  print("clevis", CLEVIS_VERSION, "");
  ExitCode code = ExitCode::kPass;
  try {
    print("solver", load_plugin().string(), "check, study, modes, export");
  } catch (const Error& error) {
    print("solver", error.problem(), "check, study, modes, export");
    code = error.exit_code();
  }
  for (const auto& [name, file, needed_for] :
       {std::tuple("engine", kEngineLibrary, "--engine dealii, mpirun"),
        std::tuple(kMesher, kMesher, "STEP, IGES and BREP parts"),
        std::tuple(kImporter, kImporter, "SDF and URDF models")}) {
    const fs::path path = companion(file);
    print(name, fs::exists(path) ? path.string() : "not found", needed_for);
  }
  for (const Tool& tool : kTools) {
    print(tool.name, version(tool), tool.needed_for);
  }
  print("bwrap", about_sandbox(), "CAD files and models: their reader alone");
  print("cores", std::to_string(std::thread::hardware_concurrency()),
        "parts in parallel; all for one large part");
  print("memory", fmt::format("{:.1f} GiB", memory_GiB()), "");
  print("temporary", fs::temp_directory_path().string(), "clevis mesh, study");
  return code;
}

Run declare_doctor(CLI::App& /*command*/) {
  return doctor_command;
}

}  // namespace clevis::app
