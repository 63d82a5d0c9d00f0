#include "report/view/input_file.h"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include "base/messages/errors.h"

namespace clevis::report {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file) {
  throw Error("I001", file.string(),
              std::string("cannot read file: ") + std::strerror(errno),
              "Check the path and its permissions.");
}

}  // namespace

std::string file_text(const std::filesystem::path& file) {
  std::error_code failure;
  // A pipe that nobody writes would be waited for when opened.
  const auto status = std::filesystem::status(file, failure);
  if (std::filesystem::exists(status) &&
      !std::filesystem::is_regular_file(status)) {
    throw Error("I001", file.string(), "is not a regular file",
                "Give the path of a file.");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string modified_at(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) refuse(file);
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(status.st_mtime));
}

}  // namespace clevis::report
