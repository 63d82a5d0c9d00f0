#include "app/processes/worker_pool.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "app/processes/temporary_folder.h"
#include "base/system/interrupts.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// A worker that needs this long to end what it runs when Ctrl-C comes: a
/// large child on a busy machine.
std::string slow_to_end(const fs::path& told) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "answer") << "half";
  std::ofstream(told / "new") << folder.path().string();
  fs::rename(told / "new", told / "folder");
  while (!is_interrupted()) std::this_thread::sleep_for(milliseconds(1));
  std::this_thread::sleep_for(milliseconds(1500));
  return "";
}

/// Interrupts this process once the worker has its folder.
/// @return whether that is left behind.
bool leaves_its_folder(const fs::path& told) {
  end_on_interrupts();
  const InterruptGuard guard;
  const auto interrupt = [&](std::size_t, const std::vector<std::size_t>&) {
    if (fs::exists(told / "folder")) std::raise(SIGINT);
  };
  run_workers(
      1, 1,
      [&](std::size_t) {
        return slow_to_end(told);
      },
      interrupt);
  std::string folder;
  std::getline(std::ifstream(told / "folder"), folder);
  return folder.empty() || fs::exists(folder);
}

TEST(WorkerPoolDeathTest, AnInterruptLeavesNoTemporaryFolder) {
  const TemporaryFolder told;
  EXPECT_EXIT(_exit(leaves_its_folder(told.path()) ? 1 : 0),
              testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace clevis::app
