#include "app/start/new_folder.h"

#include <system_error>

#include "base/messages/errors.h"

namespace clevis::app {

namespace fs = std::filesystem;

void require_new_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error))) return;
  if (fs::is_directory(folder, error) && fs::is_empty(folder, error)) return;
  throw Error("I005", folder.string(), "is there and not an empty folder",
              "Give the name of a new folder; nothing is overwritten.");
}

}  // namespace clevis::app
