#include "support/source_dir.h"

namespace clevis::support {

std::filesystem::path source_dir() {
  return CLEVIS_SOURCE_DIR;
}

}  // namespace clevis::support
