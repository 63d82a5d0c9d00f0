#include "elasticity/direct/memory_forecast.h"

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis::elasticity {
namespace {

constexpr double kGibi = 1024.0 * 1024.0 * 1024.0;

// 5.97 million entries were counted for 20,325 degrees of freedom in 3-D.
TEST(MemoryForecast, AgreesWithACountedFactor) {
  EXPECT_NEAR(factor_bytes(3, 20325.0), 8.0 * 5.97e6, 0.05 * 8.0 * 5.97e6);
}

TEST(MemoryForecast, RefusesWhatDoesNotFit) {
  EXPECT_NO_THROW(
      require_memory(factor_bytes(3, 1e5), 1e5, 24.0 * kGibi, "part"));
  try {
    require_memory(factor_bytes(3, 1e7), 1e7, 24.0 * kGibi, "part BIG");
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F004");
    EXPECT_EQ(error.exit_code(), ExitCode::kResourceLimit);
  }
  EXPECT_NO_THROW(
      require_memory(factor_bytes(2, 1e7), 1e7, 24.0 * kGibi, "part"));
}

TEST(MemoryForecast, OfAMillionFreedomsWithoutTheMatrix) {
  for (int degree = 2; degree <= 4; ++degree) {
    const double bytes = multigrid_bytes(degree, 1, 1e6, 40.0);
    EXPECT_GT(bytes, 2.0 * kGibi);
    EXPECT_LT(bytes, 8.0 * kGibi);
    EXPECT_LT(bytes, factor_bytes(3, 1e6));
  }
  EXPECT_NO_THROW(
      require_multigrid_memory(2, 1, 1e6, 40.0, 24.0 * kGibi, "part"));
  try {
    require_multigrid_memory(2, 1, 2e7, 40.0, 24.0 * kGibi, "part BIG");
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F004");
    EXPECT_EQ(error.exit_code(), ExitCode::kResourceLimit);
    EXPECT_NE(error.problem().find("iterative"), std::string::npos);
  }
}

}  // namespace
}  // namespace clevis::elasticity
