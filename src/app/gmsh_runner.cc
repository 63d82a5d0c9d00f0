#include "app/gmsh_runner.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/temporary_folder.h"
#include "base/errors.h"

namespace clevis::app {
namespace {

using std::filesystem::path;

constexpr int kNotStarted = 127;                  // as a shell says it
constexpr rlim_t kLargestFile = rlim_t{1} << 30;  // [bytes], mesh or log

std::string read_file(const path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// "VALUE\0"-terminated strings as execvpe wants them.
std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& text : strings) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Replaces the child process by the program; its output goes to `log`.
[[noreturn]] void become(char* const* arguments, char* const* environment,
                         const char* folder, const char* log, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // Ctrl-C on clevis ends gmsh too
  const rlimit size{kLargestFile, kLargestFile};
  setrlimit(RLIMIT_FSIZE, &size);
  const int in = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int out = open(log, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (getppid() == parent && in >= 0 && out >= 0 && dup2(in, 0) == 0 &&
      dup2(out, 1) == 1 && dup2(out, 2) == 2 && chdir(folder) == 0) {
    execvpe(arguments[0], arguments, environment);
  }
  _exit(kNotStarted);
}

/// Wait status of the child, or nothing if it was killed for taking too long.
std::optional<int> wait_for(pid_t child, std::chrono::milliseconds timeout) {
  constexpr std::chrono::milliseconds kPause(5);
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > deadline) {
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(kPause);
  }
  return status;
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

[[noreturn]] void refuse(const path& geometry, const std::string& problem,
                         const std::string& remedy) {
  throw Error("M010", geometry.string(), problem, remedy);
}

std::optional<int> run(std::vector<std::string> arguments, const path& folder,
                       const path& log, std::chrono::milliseconds timeout) {
  const char* search = std::getenv("PATH");
  std::vector<std::string> environment = {
      std::string("PATH=") + (search != nullptr ? search : "/usr/bin:/bin"),
      "HOME=" + folder.string(), "TMPDIR=" + folder.string(), "LC_ALL=C"};
  const std::vector<char*> argument_list = pointers(arguments);
  const std::vector<char*> environment_list = pointers(environment);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) {
    throw Error(
        "M010", arguments[0],
        std::string("no process could be started: ") + std::strerror(errno),
        "Close other programs and try again.");
  }
  if (child == 0) {
    become(argument_list.data(), environment_list.data(), folder.c_str(),
           log.c_str(), parent);
  }
  setpgid(child, child);  // whoever comes first; the other call does nothing
  return wait_for(child, timeout);
}

}  // namespace

std::string run_gmsh(const path& geometry, std::chrono::milliseconds timeout,
                     const std::string& program) {
  if (!std::ifstream(geometry)) {
    throw Error("I001", geometry.string(), "the geometry cannot be read",
                "Check the part's `geometry`; it is relative to the scene.");
  }
  const TemporaryFolder folder;
  const path mesh = folder.path() / "part.msh";
  const path log = folder.path() / "gmsh.log";
  const std::optional<int> status =
      run({program, "-3", "-format", "msh41", "-nt", "1", "-o", mesh.string(),
           std::filesystem::absolute(geometry).string()},
          folder.path(), log, timeout);
  if (!status) {
    refuse(geometry,
           fmt::format("gmsh did not finish within {:.3g} s",
                       std::chrono::duration<double>(timeout).count()),
           "Coarsen the mesh, or look for an endless loop in the .geo.");
  }
  if (WIFEXITED(*status) && WEXITSTATUS(*status) == kNotStarted) {
    refuse(geometry, fmt::format("{} could not be started", program),
           "Install gmsh (Debian: apt install gmsh).");
  }
  const std::string error = first_error(read_file(log));
  if (!WIFEXITED(*status) || WEXITSTATUS(*status) != 0 || !error.empty()) {
    refuse(geometry,
           error.empty() ? "gmsh crashed without a message"
                         : "gmsh says: " + error,
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
