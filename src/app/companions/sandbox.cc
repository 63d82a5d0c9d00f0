#include "app/companions/sandbox.h"

#include <chrono>

#include "app/processes/child_process.h"
#include "app/processes/lone_program.h"
#include "app/processes/temporary_folder.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBubblewrap = "bwrap";

/// Where programs find their libraries, and which of two they take.
constexpr const char* kSystem[] = {
    "/usr/lib", "/usr/lib64",       "/usr/local/lib",   "/lib",
    "/lib64",   "/etc/ld.so.cache", "/etc/alternatives"};

void add_mount(const char* how, const fs::path& path,
               std::vector<std::string>& command) {
  command.insert(command.end(), {how, path.string(), path.string()});
}

/// @param program  of bubblewrap.
std::vector<std::string> command_of(const fs::path& bubblewrap,
                                    const std::vector<fs::path>& input,
                                    const fs::path& folder) {
  std::vector<std::string> command{bubblewrap.string(), "--unshare-all",
                                   "--die-with-parent", "--new-session",
                                   "--cap-drop",        "ALL"};
  for (const char* path : kSystem) add_mount("--ro-bind-try", path, command);
  command.insert(command.end(), {"--dev", "/dev"});
  add_mount("--bind", folder, command);
  for (const fs::path& path : input) add_mount("--ro-bind", path, command);
  command.insert(command.end(), {"--chdir", folder.string(), "--"});
  return command;
}

/// Whether bubblewrap can start a program as it starts a companion here: a
/// container or a kernel may not let it. The dynamic linker stands for one.
bool is_permitted(const fs::path& bubblewrap) {
  constexpr std::chrono::seconds kMost(5);
  const TemporaryFolder folder;
  const fs::path linker = fs::exists("/lib64/ld-linux-x86-64.so.2")
                              ? "/lib64/ld-linux-x86-64.so.2"
                              : "/lib/ld-linux-aarch64.so.1";
  std::vector<std::string> arguments =
      command_of(bubblewrap, {}, folder.path());
  arguments.insert(arguments.end(), {linker.string(), "--version"});
  return run_child({.arguments = arguments,
                    .folder = folder.path(),
                    .log = folder.path() / "sandbox.log",
                    .starts_others = true},
                   kMost)
      .succeeded();
}

enum class Sandbox { kMissing, kForbidden, kUsable };

Sandbox sandbox() {
  static const Sandbox kHere = [] {
    const fs::path bubblewrap = find_program(kBubblewrap);
    if (bubblewrap.empty()) return Sandbox::kMissing;
    return is_permitted(bubblewrap) ? Sandbox::kUsable : Sandbox::kForbidden;
  }();
  return kHere;
}

}  // namespace

std::vector<std::string> sandbox_command(const fs::path& program,
                                         const std::vector<fs::path>& input,
                                         const fs::path& folder) {
  // A script, as tests have them, needs more than libraries.
  if (!is_binary(program) || sandbox() != Sandbox::kUsable) return {};
  std::vector<fs::path> seen = input;
  seen.push_back(program);
  return command_of(find_program(kBubblewrap), seen, folder);
}

std::string about_sandbox() {
  switch (sandbox()) {
    case Sandbox::kMissing:
      return "not found";
    case Sandbox::kForbidden:
      return "found, but not permitted here: not used";
    case Sandbox::kUsable:
      break;
  }
  return find_program(kBubblewrap).string();
}

}  // namespace clevis::app
