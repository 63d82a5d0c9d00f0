#include "app/scenes/geometry_stamp.h"

#include <cassert>
#include <fstream>

#include <fmt/format.h>

#include "app/scenes/geometry_files.h"
#include "base/bytes/fingerprint.h"
#include "base/messages/errors.h"
#include "cad/source_text.h"

namespace clevis::app {
namespace {

constexpr std::string_view kFormatEnd = "$EndMeshFormat\n";
constexpr std::string_view kLabel = "clevis geometry fnv1a ";

}  // namespace

std::string geometry_stamp(const part::PartDefinition& part,
                           const part::GeometryInput& input) {
  std::string content = geometry_content(part.geometry);
  if (!input.parameters.empty()) {
    content += '\0' + part::text_of(input.parameters);
  }
  if (part::is_solid_file(part.geometry)) {
    content += '\0' + cad::text_of(input.solid);
  }
  return fingerprint(content);
}

bool has_current_mesh(const part::PartDefinition& part,
                      const part::GeometryInput& input) {
  return stamp_of(part.mesh) == geometry_stamp(part, input);
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

void require_current_mesh(const part::PartDefinition& part,
                          const part::GeometryInput& input) {
  std::error_code failure;
  const auto is_file = [&failure](const std::filesystem::path& file) {
    return std::filesystem::is_regular_file(file, failure);
  };
  if (!is_file(part.geometry)) return;
  if (!input.parameters.empty() && !is_file(part.mesh)) {
    throw Error("M011", part.mesh.string(),
                fmt::format("part {}: {} has not been meshed with these "
                            "parameters",
                            part.name, part.geometry.filename().string()),
                "Run `clevis mesh` with the same --set, or `clevis check` with "
                "--mesh.");
  }
  const std::optional<std::string> stamp = stamp_of(part.mesh);
  if (!stamp || *stamp == geometry_stamp(part, input)) return;
  throw Error("M011", part.mesh.string(),
              fmt::format("part {}: the mesh was made from another version of "
                          "{}, or of a file that it reads",
                          part.name, part.geometry.filename().string()),
              "Run `clevis mesh` on the scene.");
}

}  // namespace clevis::app
