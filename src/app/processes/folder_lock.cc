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

#include "base/messages/errors.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

[[noreturn]] void refuse(const fs::path& folder, const std::string& reason) {
  throw Error("I002", folder.string(), "cannot be written: " + reason,
              "Check that the folder may be written, or choose another with "
              "--out.");
}

/// Makes the folder and the file of its lock.
int opened(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) refuse(folder, failure.message());
  const fs::path file = folder / ".lock";
  const int descriptor =
      open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK,
           0666);
  if (descriptor < 0) refuse(folder, std::strerror(errno));
  return descriptor;
}

/// Tries at least once.
bool locked_within(int descriptor, milliseconds time, milliseconds pause) {
  const auto deadline = std::chrono::steady_clock::now() + time;
  for (;;) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno != EWOULDBLOCK && errno != EINTR) return true;  // no such locks
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : descriptor_(opened(folder)) {
  constexpr milliseconds kDying(500), kPause(20);
  if (locked_within(descriptor_, kDying, kPause)) return;
  close(descriptor_);
  throw Error("I006", folder.string(),
              "another clevis is writing its results into this folder",
              "Wait until it has ended, or give another --out.");
}

bool is_freed_within(const fs::path& folder, milliseconds time) {
  constexpr milliseconds kPause(200);
  const int descriptor = opened(folder);
  const bool is_free = locked_within(descriptor, time, kPause);
  close(descriptor);
  return is_free;
}

FolderLock::~FolderLock() {
  close(descriptor_);
}

}  // namespace clevis::app
