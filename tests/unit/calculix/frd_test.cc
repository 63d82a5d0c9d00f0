#include "calculix/frd.h"

#include <sstream>

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis::calculix {
namespace {

// As CalculiX 2.20 writes it: fields of 12 characters that touch.
constexpr const char* kFrd =
    "    1C\n"
    "    2C                             2                                     "
    "1\n"
    " -1         1 0.00000E+00 0.00000E+00 0.00000E+00\n"
    " -1         2 1.00000E+00 0.00000E+00 0.00000E+00\n"
    " -3\n"
    "  100CL  101 1.000000000           2                     0    1           "
    "1\n"
    " -4  DISP        4    1\n"
    " -5  D1          1    2    1    0\n"
    " -1         1 1.00000E-03-2.00000E-03 3.00000E-03\n"
    " -1         2-1.00000E+00 0.00000E+00 5.00000E-01\n"
    " -3\n"
    " -4  STRESS      6    1\n"
    " -5  SXX         1    4    1    1\n"
    " -1         1 1.00000E+00 2.00000E+00 3.00000E+00 4.00000E+00 5.00000E+00 "
    "6.00000E+00\n"
    " -1         "
    "2-1.00000E+00-2.00000E+00-3.00000E+00-4.00000E+00-5.00000E+00-6.00000E+"
    "00\n"
    " -3\n"
    " 9999\n";

std::string refused(const std::string& text) {
  std::istringstream in(text);
  try {
    read_frd(in, 2, "part.frd");
  } catch (const Error& error) {
    EXPECT_EQ(error.place(), "part.frd");
    return error.code() + ": " + error.problem();
  }
  return "not refused";
}

std::string replaced(std::string text, const std::string& from,
                     const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(CalculixFrd, ReadsDisplacementsAndStressesInSi) {
  std::istringstream in(kFrd);
  const auto steps = read_frd(in, 2, "part.frd");
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_TRUE(steps[0].displacement.col(0).isApprox(
      Eigen::Vector3d(1e-6, -2e-6, 3e-6)));
  EXPECT_TRUE(
      steps[0].displacement.col(1).isApprox(Eigen::Vector3d(-1e-3, 0, 5e-4)));
  for (int k = 0; k < 6; ++k) {
    EXPECT_DOUBLE_EQ(steps[0].stress(k, 0), 1e6 * (k + 1));
    EXPECT_DOUBLE_EQ(steps[0].stress(k, 1), -1e6 * (k + 1));
  }
}

TEST(CalculixFrd, WhatIsNotWholeIsRefused) {
  const std::string whole = kFrd;
  EXPECT_EQ(refused(""), "I004: the file holds no displacements");
  EXPECT_EQ(refused(whole.substr(0, whole.find(" -4  STRESS"))),
            "I004: a step has no stresses");
  EXPECT_EQ(refused(whole.substr(0, whole.find(" -1         2-1.0"))),
            "I004: the file ends inside a block");
  EXPECT_EQ(refused(replaced(whole, " 3.00000E-03", "         NaN")),
            "I004: a node has no finite value");
  EXPECT_EQ(refused(replaced(whole, " 3.00000E-03", " 3.0000*E-03")),
            "I004: \"3.0000*E-03\" is no number");
  EXPECT_EQ(refused(replaced(whole, " -1         2-1.00000E+00 0.00000E+00 5",
                             " -1         3-1.00000E+00 0.00000E+00 5")),
            "I004: node 3 is not in the deck");
  EXPECT_EQ(refused(replaced(whole, " -1         2-1.00000E+00 0.00000E+00 5",
                             " -1         1-1.00000E+00 0.00000E+00 5")),
            "I004: a node has no finite value");
}

}  // namespace
}  // namespace clevis::calculix
