#include "app/processes/folder_lock.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/errors.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& reason) {
  throw Error("I002", folder.string(), "cannot be written: " + reason,
              "Check that the folder may be written, or choose another with "
              "--out.");
}

bool locked(int descriptor) {
  constexpr int kTries = 25;
  constexpr std::chrono::milliseconds kPause(20);
  for (int i = 0; i < kTries; ++i) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno != EWOULDBLOCK && errno != EINTR) return true;  // no such locks
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) refuse(folder, failure.message());
  const fs::path file = folder / ".lock";
  descriptor_ =
      open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK,
           0666);
  if (descriptor_ < 0) refuse(folder, std::strerror(errno));
  if (locked(descriptor_)) return;
  close(descriptor_);
  throw Error("I006", folder.string(),
              "another clevis is writing its results into this folder",
              "Wait until it has ended, or give another --out.");
}

FolderLock::~FolderLock() {
  close(descriptor_);
}

}  // namespace clevis::app
