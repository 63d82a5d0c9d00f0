#include "app/solids/solid_mesher.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <sys/wait.h>

#include "app/processes/child_process.h"
#include "app/processes/temporary_folder.h"
#include "base/companion.h"
#include "base/errors.h"
#include "cad/source_file.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A damaged number can keep OpenCASCADE for ever.
constexpr std::chrono::milliseconds kMostToRead{30'000};

[[noreturn]] void refuse(const fs::path& file, const std::string& problem,
                         const char* remedy) {
  throw Error("M010", file.string(), problem, remedy);
}

/// @throws Error M010 if the mesher did not come to an answer.
void require_end(const ChildOutcome& outcome, const fs::path& file,
                 std::chrono::milliseconds timeout, std::size_t memory) {
  constexpr const char* kSimplify =
      "Remove detail that carries no load, or give the part a larger "
      "mesh_size.";
  if (!outcome.was_found()) {
    refuse(file, "clevis-mesher could not be started",
           "Reinstall clevis: this program belongs to it.");
  }
  if (!outcome.status) {
    refuse(file,
           fmt::format("the mesher did not finish within {:.3g} s",
                       std::chrono::duration<double>(timeout).count()),
           kSimplify);
  }
  if (outcome.succeeded()) return;
  const std::string limit = fmt::format("{} MiB are its limit", memory >> 20);
  if (WIFSIGNALED(*outcome.status)) {
    refuse(file,
           fmt::format("the mesher died of signal {} ({}) on this file",
                       WTERMSIG(*outcome.status), limit),
           kSimplify);
  }
  refuse(file, "the mesher gave up on this file; " + limit, kSimplify);
}

}  // namespace

MesherAnswer run_mesher(cad::Request request, std::chrono::milliseconds timeout,
                        std::size_t memory, const fs::path& program) {
  cad::require_solid_file(request.file);
  const TemporaryFolder folder;
  const fs::path question = folder.path() / "request.json";
  const fs::path answer = folder.path() / "answer.json";
  const bool has_mesh = !request.mesh.empty();
  if (!has_mesh) timeout = std::min(timeout, kMostToRead);
  if (has_mesh) request.mesh = folder.path() / "part.msh";
  const fs::path file = std::exchange(request.file, fs::absolute(request.file));
  request.format = part::geometry_format(file);
  std::ofstream(question, std::ios::binary) << text_of(request);
  const fs::path mesher = program.empty() ? companion(kMesher) : program;
  const ChildOutcome outcome = run_child(
      {.arguments = {mesher.string(), question.string(), answer.string()},
       .folder = folder.path(),
       .log = folder.path() / "mesher.log",
       .memory = memory},
      timeout);
  require_end(outcome, file, timeout, memory);
  try {
    MesherAnswer found{cad::read_answer(read_file(answer)), {}};
    if (has_mesh) found.mesh = read_file(request.mesh);
    return found;
  } catch (const Error& error) {
    // The child knows the file by its absolute path.
    throw Error(error.code(), file.string(), error.problem(), error.remedy());
  } catch (const std::exception& failure) {
    refuse(
        file,
        fmt::format("the mesher's answer cannot be read: {}", failure.what()),
        "Please report this with the file.");
  }
}

}  // namespace clevis::app
