#pragma once

#include <chrono>
#include <filesystem>

namespace clevis::app {

/// Holds a folder of results for this process and its children while it lives,
/// by a lock on the file `.lock` in it. The lock ends with the last of them,
/// however they end; the file stays.
class FolderLock {
 public:
  /// Makes the folder if it is missing.
  /// @throws Error I006 if another process holds it for longer than children of
  ///   a killed one need to die (0.5 s), I002 if it cannot be written.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// Waits until no process holds the folder. @return whether that came within
/// the time. @throws Error I002 if its lock cannot be read.
bool is_freed_within(const std::filesystem::path& folder,
                     std::chrono::milliseconds time);

}  // namespace clevis::app
