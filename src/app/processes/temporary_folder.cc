#include "app/processes/temporary_folder.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include <stdlib.h>

#include "base/messages/errors.h"

namespace clevis::app {

TemporaryFolder::TemporaryFolder() {
  std::error_code no_folder;
  const std::filesystem::path parent =
      std::filesystem::temp_directory_path(no_folder);
  std::string name = (parent / "clevis-XXXXXX").string();
  if (no_folder || mkdtemp(name.data()) == nullptr) {
    throw Error("I002", name,
                std::string("no temporary folder could be made: ") +
                    std::strerror(errno),
                "Point TMPDIR to a folder that may be written.");
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;  // a leftover folder in /tmp harms nobody
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace clevis::app
