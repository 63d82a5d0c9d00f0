#include "app/scenes/gmsh_runner.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <sys/wait.h>

#include "app/processes/child_process.h"
#include "app/processes/temporary_folder.h"
#include "base/messages/errors.h"

namespace clevis::app {
namespace {

using std::filesystem::path;

std::string read_file(const path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// gmsh's first "Error   : ..." line: later ones are its consequences.
std::string first_error(const std::string& log) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("Error")) continue;
    const std::size_t start = line.find_first_not_of(" :", 5);
    if (start != std::string::npos) return line.substr(start);
  }
  return {};
}

/// The last line that gmsh, what it is linked to, or a script in its place
/// wrote in words of its own.
std::string last_words(const std::string& log) {
  constexpr std::size_t kLongest = 300;
  std::istringstream lines(log);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Info") || line.starts_with("Progress")) continue;
    if (line.find_first_not_of(" \t\r-") != std::string::npos) last = line;
  }
  return last.substr(0, kLongest);
}

/// How a child that failed ended.
std::string ending(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("was ended by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  }
  return fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

/// Why gmsh made no mesh.
std::string failure(const ChildOutcome& outcome, const std::string& error,
                    const std::string& log) {
  if (!error.empty()) return "gmsh says: " + error;
  const std::string words = last_words(log);
  return "gmsh " + ending(*outcome.status) +
         (words.empty() ? " without a message" : " and says: " + words);
}

[[noreturn]] void refuse(const path& geometry, const std::string& problem,
                         const std::string& remedy) {
  throw Error("M010", geometry.string(), problem, remedy);
}

/// The number of a last line that no newline ends; 0: one does.
std::ptrdiff_t open_last_line(const std::string& script) {
  if (script.empty() || script.back() == '\n') return 0;
  return std::ranges::count(script, '\n') + 1;
}

/// What stands on the last line that no newline ends, but for its first
/// statement, gmsh leaves out without a word. Behind an Include it reads it, as
/// if it stood in the file that includes: beside that are no files of the user.
/// @return the file to open.
path with_last_line(const path& geometry, const std::string& script,
                    const path& folder) {
  const std::ptrdiff_t line = open_last_line(script);
  if (line == 0) return geometry;
  const std::string last = script.substr(script.rfind('\n') + 1);
  const bool names_file = std::ranges::any_of(
      std::array{"Include", "Merge", "ShapeFromFile"}, [&](const char* word) {
        return last.find(word) != std::string::npos;
      });
  if (names_file ||
      geometry.string().find_first_of("\"\\\n") != std::string::npos) {
    throw Error("M010", fmt::format("{}:{}", geometry.string(), line),
                "the last line ends without a newline: gmsh would leave out "
                "what stands on it",
                "End the last line of the file with a newline.");
  }
  const path script_of_all = folder / "last_line.geo";
  std::ofstream(script_of_all)
      << fmt::format("Include \"{}\";\n", geometry.string());
  return script_of_all;
}

}  // namespace

std::string run_gmsh(const path& geometry,
                     const std::vector<part::GeometryParameter>& parameters,
                     std::chrono::milliseconds timeout,
                     const std::string& program) {
  std::error_code ignored;
  // A pipe that nobody writes would be waited for when opened.
  if (!std::filesystem::is_regular_file(geometry, ignored) ||
      !std::ifstream(geometry)) {
    throw Error("I001", geometry.string(), "the geometry cannot be read",
                "Check the part's `geometry`; it is relative to the scene.");
  }
  const TemporaryFolder folder;
  const path mesh = folder.path() / "part.msh";
  const path log = folder.path() / "gmsh.log";
  std::vector<std::string> arguments = {
      program, "-3", "-format", "msh41", "-nt", "1", "-o", mesh.string()};
  for (const part::GeometryParameter& parameter : parameters) {
    arguments.insert(arguments.end(), {"-setnumber", parameter.name,
                                       fmt::format("{}", parameter.value)});
  }
  const path opened = with_last_line(std::filesystem::absolute(geometry),
                                     read_file(geometry), folder.path());
  arguments.push_back(opened.string());
  const ChildOutcome outcome = run_child(
      {.arguments = arguments, .folder = folder.path(), .log = log}, timeout);
  if (!outcome.status) {
    refuse(geometry,
           fmt::format("gmsh did not finish within {:.3g} s by the clock, the "
                       "most that a .geo gets",
                       std::chrono::duration<double>(timeout).count()),
           "Coarsen the mesh, or look for an endless loop in the .geo; "
           "or mesh it by hand and give the part's `mesh`.");
  }
  const std::string said = read_file(log);
  // One whose libraries are missing ends alike, in words of the loader.
  if (!outcome.was_found() && last_words(said).empty()) {
    refuse(geometry, fmt::format("{} could not be started", program),
           "Install gmsh (Debian: apt install gmsh).");
  }
  const std::string error = first_error(said);
  // What gmsh says of a shell that it may not start (run_child()).
  if (error.find("aborting system call") != std::string::npos) {
    refuse(geometry, "it starts another program (SystemCall, OnelabRun)",
           "Take the call out: a geometry starts no program in clevis.");
  }
  if (!outcome.succeeded() || !error.empty()) {
    refuse(geometry, failure(outcome, error, said),
           "Open the file in gmsh and correct it there.");
  }
  std::string text = read_file(mesh);
  if (!text.starts_with("$MeshFormat")) {
    refuse(geometry, "gmsh wrote no mesh",
           "See that the .geo has a volume and a Physical Volume.");
  }
  return text;
}

}  // namespace clevis::app
