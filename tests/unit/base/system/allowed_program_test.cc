#include "base/system/allowed_program.h"

#include <cerrno>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace clevis {
namespace {

/// Exit code of a process that forbids itself all programs but one and starts
/// /bin/true: 0, or 7 where it is refused.
int start_true(bool is_allowed) {
  static const char kTrue[] = "/bin/true";
  const pid_t child = fork();
  if (child == 0) {
    allow_only(is_allowed ? kTrue : nullptr);
    execl(kTrue, kTrue, static_cast<char*>(nullptr));
    _exit(errno == EACCES ? 7 : 8);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(AllowedProgram, IsTheOneAtThePointer) {
  EXPECT_EQ(start_true(true), 0);
}

TEST(AllowedProgram, IsNoneWithoutAPointer) {
  EXPECT_EQ(start_true(false), 7);
}

}  // namespace
}  // namespace clevis
