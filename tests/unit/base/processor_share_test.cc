#include "base/processor_share.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace clevis {
namespace {

TEST(ProcessorShare, IsOfThoseAtWork) {
  EXPECT_EQ(ProcessorShare{}.now(), 1);
  EXPECT_EQ((ProcessorShare{4}.now()), 4);
  SharedCount at_work(2);
  const ProcessorShare share{4, &at_work};
  EXPECT_EQ(share.now(), 2);
  at_work.set(3);
  EXPECT_EQ(share.now(), 1);
  at_work.set(9);
  EXPECT_EQ(share.now(), 1);
  at_work.set(0);
  EXPECT_EQ(share.now(), 4);
}

TEST(ProcessorShare, AForkSeesWhatItsParentCounts) {
  SharedCount at_work(2);
  int start[2];
  ASSERT_EQ(pipe(start), 0);
  const pid_t child = fork();
  if (child == 0) {
    char byte{};
    if (read(start[0], &byte, 1) != 1) _exit(100);
    _exit(ProcessorShare{8, &at_work}.now());
  }
  at_work.set(1);
  ASSERT_EQ(write(start[1], "x", 1), 1);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 8);
}

}  // namespace
}  // namespace clevis
