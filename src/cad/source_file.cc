#include "cad/source_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::cad {
namespace {

using part::GeometryFormat;

constexpr std::size_t kHead = 512;  // [bytes]
constexpr std::uintmax_t kLargest = std::uintmax_t{256} << 20;

std::string head_of(const std::filesystem::path& file) {
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) {
    throw Error(
        "I001", file.string(), "there is no such file",
        "Check the path; a part's `geometry` is relative to the scene.");
  }
  // A pipe that nobody writes would be waited for when opened.
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, failure)) {
    stream.open(file, std::ios::binary);
  }
  if (!stream.is_open()) {
    throw Error("I001", file.string(), "the geometry cannot be read",
                "Check the part's `geometry`; it is relative to the scene.");
  }
  std::string head(kHead, '\0');
  stream.read(head.data(), std::streamsize(head.size()));
  head.resize(std::size_t(stream.gcount()));
  return head;
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
  }
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return start == text.npos ? "" : text.substr(start);
}

/// Column 73 of an IGES file's first line names the start section, the line's
/// number follows.
bool begins_as_iges(std::string_view head) {
  constexpr std::size_t kSection = 72, kLine = 80;
  return head.size() >= kLine && head[kSection] == 'S' &&
         head.substr(0, kLine).find('\n') == head.npos &&
         std::ranges::all_of(head.substr(kSection + 1, 7), [](unsigned char c) {
           return c == ' ' || std::isdigit(c) != 0;
         });
}

bool begins_as(GeometryFormat format, std::string_view head) {
  if (format == GeometryFormat::kIges) return begins_as_iges(head);
  const std::string_view text = without_blanks(head);
  if (format == GeometryFormat::kStep) return text.starts_with("ISO-10303-21");
  return text.starts_with("DBRep_DrawableShape") ||
         text.starts_with("CASCADE Topology");
}

}  // namespace

void require_solid_file(const std::filesystem::path& file) {
  const std::string head = head_of(file);
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (size > kLargest) {
    throw Error("M015", file.string(),
                fmt::format("the file has {} MiB, {} is the most", size >> 20,
                            kLargest >> 20),
                "Export the one part alone, without threads and engravings.");
  }
  if (begins_as(part::geometry_format(file), head)) return;
  throw Error("M015", file.string(),
              fmt::format("the file does not begin as a {} file does",
                          file.extension().string()),
              "Export it again as STEP (AP203, AP214 or AP242); a script of "
              "gmsh must be called .geo.");
}

}  // namespace clevis::cad
