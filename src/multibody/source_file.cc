#include "multibody/source_file.h"

#include <array>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::multibody {
namespace {

constexpr std::uintmax_t kLargest = std::uintmax_t{16} << 20;

}  // namespace

void require_model_file(const std::filesystem::path& file) {
  std::error_code failure;
  // A pipe that nobody writes would be waited for when opened.
  const bool is_file = std::filesystem::is_regular_file(file, failure);
  std::ifstream stream;
  if (is_file) stream.open(file, std::ios::binary);
  if (!is_file || !stream) {
    throw Error("I001", file.string(), "the model cannot be read",
                "Give the path of an .sdf or .urdf file.");
  }
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (size > kLargest) {
    throw Error("S013", file.string(),
                fmt::format("the file has {} MiB, {} is the most", size >> 20,
                            kLargest >> 20),
                "Leave out what is no link and no joint.");
  }
  std::array<char, 512> bytes{};
  stream.read(bytes.data(), bytes.size());
  std::string_view head(bytes.data(), std::size_t(stream.gcount()));
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (head.starts_with(kByteOrderMark)) {
    head.remove_prefix(kByteOrderMark.size());
  }
  const std::size_t start = head.find_first_not_of(" \t\r\n");
  if (start != head.npos && head[start] == '<') return;
  throw Error("S013", file.string(), "the file does not begin as XML does",
              "Give an SDF file (<sdf>) or a URDF file (<robot>).");
}

}  // namespace clevis::multibody
