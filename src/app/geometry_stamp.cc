#include "app/geometry_stamp.h"

#include <cassert>
#include <fstream>

#include <fmt/format.h>

#include "app/geometry_files.h"
#include "base/errors.h"
#include "base/fingerprint.h"

namespace clevis::app {
namespace {

constexpr std::string_view kFormatEnd = "$EndMeshFormat\n";
constexpr std::string_view kLabel = "clevis geometry fnv1a ";

}  // namespace

std::string geometry_stamp(std::string_view geometry) {
  return fingerprint(geometry);
}

std::string stamped(std::string mesh, std::string_view stamp) {
  const std::size_t at = mesh.find(kFormatEnd);
  assert(at != std::string::npos && "not a .msh");
  mesh.insert(at + kFormatEnd.size(),
              fmt::format("$Comments\n{}{}\n$EndComments\n", kLabel, stamp));
  return mesh;
}

std::optional<std::string> stamp_of(const std::filesystem::path& mesh) {
  constexpr std::size_t kHead = 512;  // the stamp stands at the top
  std::string head(kHead, '\0');
  std::ifstream stream(mesh, std::ios::binary);
  stream.read(head.data(), std::streamsize(head.size()));
  head.resize(std::size_t(stream.gcount()));
  const std::size_t label = head.find(kLabel);
  if (label == std::string::npos) return std::nullopt;
  const std::size_t start = label + kLabel.size();
  return head.substr(start, head.find('\n', start) - start);
}

void require_current_mesh(const part::PartDefinition& part) {
  if (part.geometry.empty() || !std::ifstream(part.geometry)) return;
  const std::optional<std::string> stamp = stamp_of(part.mesh);
  if (!stamp || *stamp == geometry_stamp(geometry_content(part.geometry))) {
    return;
  }
  throw Error("M011", part.mesh.string(),
              fmt::format("part {}: the mesh was made from another version of "
                          "{}, or of a file that it reads",
                          part.name, part.geometry.filename().string()),
              "Run `clevis mesh` on the scene.");
}

}  // namespace clevis::app
