#include <cstdlib>
#include <fstream>
#include <string>

#include "fuzz/fuzz_target.h"

namespace clevis::testing {
namespace {

/// In memory where the system has such a folder.
class InputFolder {
 public:
  InputFolder() {
    std::string name = std::filesystem::exists("/dev/shm")
                           ? "/dev/shm/clevis-fuzz-XXXXXX"
                           : "/tmp/clevis-fuzz-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
  }
  ~InputFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::filesystem::path as_file(const std::uint8_t* data, std::size_t size,
                              const char* name) {
  static const InputFolder folder;
  const std::filesystem::path file = folder.path() / name;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(data),
               static_cast<std::streamsize>(size));
  return file;
}

}  // namespace clevis::testing
