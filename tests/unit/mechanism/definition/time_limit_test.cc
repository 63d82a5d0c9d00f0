#include "mechanism/definition/time_limit.h"

#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

double now = 0.0;  // [s]

double test_clock() {
  return now;
}

TEST(TimeLimit, ForecastsBothPassesByTheProgressOfTheFirst) {
  now = 100.0;
  TimeLimit limit(1e9, 10.0, 2, test_clock);
  for (double t = 0.1; t < 5.0; t += 0.1) {
    now = 100.0 + 3.0 * t;  // 3 s of the processor for each of the motion
    EXPECT_FALSE(limit.is_over(t));
  }
  EXPECT_NEAR(limit.forecast(), 60.0, 1e-6);
  now = 130.0;
  limit.end_pass();
  now = 133.0;
  EXPECT_FALSE(limit.is_over(1.0));
  EXPECT_NEAR(limit.forecast(), 60.0, 1e-6);
}

TEST(TimeLimit, SharesThePassesAlike) {
  TimeLimit limit(60.0, 10.0, 2, test_clock);
  EXPECT_DOUBLE_EQ(limit.share(0.0), 0.0);
  EXPECT_DOUBLE_EQ(limit.share(4.0), 0.2);
  limit.end_pass();
  EXPECT_DOUBLE_EQ(limit.share(0.0), 0.5);
  EXPECT_DOUBLE_EQ(limit.share(10.0), 1.0);
}

TEST(TimeLimit, IsOverWhenUsedUp) {
  now = 0.0;
  TimeLimit limit(60.0, 10.0, 1, test_clock);
  now = 59.9;
  EXPECT_FALSE(limit.is_over(9.0));
  now = 60.1;
  EXPECT_TRUE(limit.is_over(9.0));
}

TEST(TimeLimit, IsOverAtOnceWhereNoComputerWouldFinish) {
  now = 0.0;
  TimeLimit limit(60.0, 10.0, 1, test_clock);
  now = 3.9;
  EXPECT_FALSE(limit.is_over(1e-6)) << "too early to tell";
  now = 4.1;
  EXPECT_TRUE(limit.is_over(1e-6));
}

TEST(TimeLimit, ForgivesASlowStart) {
  now = 0.0;
  TimeLimit limit(60.0, 10.0, 1, test_clock);
  now = 3.0;
  EXPECT_FALSE(limit.is_over(1e-9));
  // 2 s of the motion in each 1 s from now on
  for (now = 3.05; now < 7.0; now += 0.05) {
    EXPECT_FALSE(limit.is_over(2.0 * (now - 3.0))) << now;
  }
}

TEST(TimeLimit, NamesALimitThatIsEnoughUnlessItIsFarOff) {
  for (const double duration : {20.0, 300.0, 390.0}) {
    now = 0.0;
    TimeLimit limit(60.0, duration, 1, test_clock);
    bool is_over = false;
    for (double t = 0.1; t < duration && !is_over; t += 0.1) {
      now = 3.01 * t;
      is_over = limit.is_over(t);
    }
    ASSERT_EQ(is_over, duration > 20.0);
    if (duration == 300.0) {  // three times 903 s, rounded up
      EXPECT_NEAR(limit.enough().value_or(0.0), 2800.0, 1e-9);
    } else if (duration == 390.0) {
      EXPECT_NEAR(limit.enough().value_or(0.0), 3600.0, 1e-9);
    }
  }
  now = 0.0;
  TimeLimit limit(60.0, 401.0, 1, test_clock);
  for (double t = 0.1; t < 21.0; t += 0.1) {
    now = 3.01 * t;
    limit.is_over(t);
  }
  EXPECT_FALSE(limit.enough().has_value()) << limit.forecast();
}

}  // namespace
}  // namespace clevis::mechanism
