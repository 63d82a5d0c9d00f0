#include "base/system/processor_share.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace clevis {
namespace {

TEST(ProcessorShare, IsOfThoseAtWork) {
  static SharedCount at_work(2);
  EXPECT_EQ(own_processors(), 1);
  share_processors(4, at_work);
  EXPECT_EQ(own_processors(), 2);
  at_work.set(3);
  EXPECT_EQ(own_processors(), 1);
  at_work.set(9);
  EXPECT_EQ(own_processors(), 1);
  at_work.set(0);
  EXPECT_EQ(own_processors(), 4);
}

TEST(ProcessorShare, AForkSeesWhatItsParentCounts) {
  static SharedCount at_work(2);
  share_processors(8, at_work);
  int start[2];
  ASSERT_EQ(pipe(start), 0);
  const pid_t child = fork();
  if (child == 0) {
    char byte{};
    if (read(start[0], &byte, 1) != 1) _exit(100);
    _exit(own_processors());
  }
  at_work.set(1);
  ASSERT_EQ(write(start[1], "x", 1), 1);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 8);
}

}  // namespace
}  // namespace clevis
