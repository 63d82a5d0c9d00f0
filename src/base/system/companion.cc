#include "base/system/companion.h"

namespace clevis {

std::filesystem::path companion(const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path beside = folder / name;
  return fs::exists(beside) ? beside
                            : folder.parent_path() / "lib/clevis" / name;
}

}  // namespace clevis
