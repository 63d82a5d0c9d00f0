#include "cad/cylinders.h"

#include <numbers>

#include <gtest/gtest.h>

#include "solid_of_cylinders.h"

namespace clevis::cad {
namespace {

constexpr double kPi = std::numbers::pi;
using Numbers = std::vector<int>;

TEST(Cylinders, HalvesOfABoreAreOne) {
  const auto found = cylinders_of(
      solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true, kPi),
                cylinder_face(2, 0.0, 0.0, 0.01, 0.016, true, kPi)}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].faces, (Numbers{1, 2}));
  EXPECT_DOUBLE_EQ(found[0].length, 0.01);
  EXPECT_DOUBLE_EQ(found[0].angle, 2 * kPi);
  EXPECT_TRUE(found[0].is_round());
}

TEST(Cylinders, PiecesEndToEndAreOneWhateverTheirOrder) {
  const auto found =
      cylinders_of(solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true),
                             cylinder_face(2, 0.0, 0.02, 0.03, 0.016, true),
                             cylinder_face(3, 0.0, 0.01, 0.02, 0.016, true)}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].faces, (Numbers{1, 2, 3}));
  EXPECT_DOUBLE_EQ(found[0].length, 0.03);
  EXPECT_DOUBLE_EQ(found[0].point.z(), 0.015);
  EXPECT_DOUBLE_EQ(found[0].angle, 2 * kPi);
}

TEST(Cylinders, AnAxisOfTheOtherSenseIsTheSame) {
  Face turned = cylinder_face(2, 0.0, -0.01, 0.0, 0.016, true, kPi);
  turned.axis = -turned.axis;
  const auto found = cylinders_of(
      solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true, kPi), turned}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].angle, 2 * kPi);
}

TEST(Cylinders, GapDiameterSideAndAxisTellThemApart) {
  const auto found =
      cylinders_of(solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true),
                             cylinder_face(2, 0.0, 0.02, 0.03, 0.016, true),
                             cylinder_face(3, 0.0, 0.0, 0.01, 0.020, true),
                             cylinder_face(4, 0.0, 0.0, 0.01, 0.016, false),
                             cylinder_face(5, 0.04, 0.0, 0.01, 0.016, true)}));
  EXPECT_EQ(found.size(), 5u);
}

TEST(Cylinders, AFilletIsNotRound) {
  const auto found = cylinders_of(
      solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true, kPi / 2)}));
  EXPECT_FALSE(found.at(0).is_round());
  EXPECT_EQ(text_of(found[0]),
            "hollow arc of diameter 16 mm, 10 mm long, middle (0, 0, 5) mm, "
            "face 1");
}

}  // namespace
}  // namespace clevis::cad
