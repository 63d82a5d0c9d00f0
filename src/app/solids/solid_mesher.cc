#include "app/solids/solid_mesher.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "app/companions/companion_answer.h"
#include "app/processes/temporary_folder.h"
#include "base/messages/errors.h"
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

}  // namespace

MesherAnswer run_mesher(cad::Request request, std::chrono::milliseconds timeout,
                        std::size_t memory, const fs::path& program) {
  cad::require_solid_file(request.file);
  const TemporaryFolder folder;
  const fs::path question = folder.path() / "request.json";
  const bool has_mesh = !request.mesh.empty();
  if (!has_mesh) timeout = std::min(timeout, kMostToRead);
  if (has_mesh) request.mesh = folder.path() / "part.msh";
  const fs::path file = std::exchange(request.file, fs::absolute(request.file));
  request.format = part::geometry_format(file);
  std::ofstream(question, std::ios::binary) << text_of(request);
  const Companion mesher{
      .name = kMesher,
      .role = "mesher",
      .code = "M010",
      .remedy =
          "Remove detail that carries no load, or give the part a larger "
          "mesh_size.",
      .program = program,
      .timeout = timeout,
      .memory = memory};
  const std::string answer =
      companion_answer(mesher, file, question, folder.path());
  try {
    MesherAnswer found{cad::read_answer(answer), {}};
    if (has_mesh) found.mesh = read_file(request.mesh);
    return found;
  } catch (const Error& error) {
    // The child knows the file by its absolute path.
    throw Error(error.code(), file.string(), error.problem(), error.remedy());
  } catch (const std::exception& failure) {
    refuse_answer(mesher, file, failure);
  }
}

}  // namespace clevis::app
