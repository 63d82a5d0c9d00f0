#pragma once

#include <filesystem>

#include "base/system/interrupts.h"

namespace clevis::app {

/// A new private folder that is removed with all its content, also at an
/// interrupt.
class TemporaryFolder {
 public:
  /// @throws Error I002 if the system's folder for temporary files is not
  ///   writable.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  DeferredInterrupt deferred_;
  std::filesystem::path path_;
};

}  // namespace clevis::app
