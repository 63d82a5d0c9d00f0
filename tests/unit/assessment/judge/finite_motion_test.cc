#include "assessment/judge/finite_motion.h"

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

// One turns farther, the other strains farther: the part does both.
TEST(FiniteMotion, BothLargestAreKept) {
  const FiniteMotion turns{0.08, 0.001, "t = 1 s"};
  const FiniteMotion strains{0.01, 0.06, "t = 2 s"};
  for (const FiniteMotion& both :
       {farther(turns, strains), farther(strains, turns)}) {
    EXPECT_EQ(both.rotation, 0.08);
    EXPECT_EQ(both.strain, 0.06);
    // 0.08 of 0.0873 rad, 0.06 of 0.05
    EXPECT_EQ(both.label, "t = 2 s");
  }
}

TEST(FiniteMotion, EitherBoundIsTold) {
  EXPECT_EQ(beyond_small_displacements({0.087, 0.049, "pull"}), "");
  EXPECT_NE(beyond_small_displacements({0.088, 0.0, "pull"}).find("turns"),
            std::string::npos);
  EXPECT_NE(beyond_small_displacements({0.0, 0.051, "pull"}).find("strains"),
            std::string::npos);
}

}  // namespace
}  // namespace clevis::assessment
