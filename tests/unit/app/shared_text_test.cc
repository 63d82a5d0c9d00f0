#include "app/processes/shared_text.h"

#include <csignal>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace clevis::app {
namespace {

TEST(SharedText, IsEmptyAtFirstAndCutWhereItIsLong) {
  SharedText text;
  EXPECT_EQ(text.get(), "");
  text.set(std::string(200, 'x'));
  EXPECT_EQ(text.get(), std::string(SharedText::kLongest, 'x'));
  text.set("p = 2");
  EXPECT_EQ(text.get(), "p = 2");
}

// What a worker writes its parent reads, never half of one and half of another.
TEST(SharedText, IsReadWholeWhileAWorkerWrites) {
  SharedText text;
  const pid_t child = fork();
  for (int i = 0; child == 0; ++i) {
    text.set(std::string(static_cast<std::size_t>(10 + i % 100),
                         static_cast<char>('a' + i % 7)));
  }
  for (int read = 0; read < 1000;) {
    const std::string seen = text.get();
    for (const char c : seen) EXPECT_EQ(c, seen.front()) << seen;
    read += seen.empty() ? 0 : 1;
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace clevis::app
