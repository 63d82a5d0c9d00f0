#include "cad/joint_cylinder.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "solid_of_cylinders.h"

namespace clevis::cad {
namespace {

constexpr double kPi = std::numbers::pi;

part::JointFaces joint_at(double x, double z) {
  return {"A", "bore_A", {x, 0.0, z}, {0.0, 0.0, -1.0}, "scene.toml:7:1"};
}

/// Numbers of the faces that a joint finds, ascending.
std::vector<int> found(const Solid& solid, const part::JointFaces& joint) {
  std::vector<int> numbers;
  for (const Cylinder& cylinder : joint_cylinders(solid, joint)) {
    numbers.insert(numbers.end(), cylinder.faces.begin(), cylinder.faces.end());
  }
  std::ranges::sort(numbers);
  return numbers;
}

Error refusal(const Solid& solid, const part::JointFaces& joint) {
  try {
    joint_cylinders(solid, joint);
  } catch (const Error& error) {
    return error;
  }
  return Error("X001", "test", "no refusal", "");
}

TEST(JointCylinder, BoreOfAnEyeGoesBeforeItsOutside) {
  const Solid eye = solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.04, false),
                              cylinder_face(2, 0.0, 0.0, 0.01, 0.016, true)});
  EXPECT_EQ(found(eye, joint_at(0.0, 0.005)), std::vector<int>{2});
}

TEST(JointCylinder, BothEarsOfAForkBelongToAJointBetweenThem) {
  const Solid fork = solid_of({cylinder_face(1, 0.0, -0.02, -0.01, 0.016, true),
                               cylinder_face(2, 0.0, 0.01, 0.02, 0.016, true),
                               cylinder_face(3, 0.0, 0.03, 0.04, 0.016, true)});
  EXPECT_EQ(found(fork, joint_at(0.0, 0.0)), (std::vector<int>{1, 2}));
}

TEST(JointCylinder, JournalsOfOneShaftAreToldByTheJointsPoint) {
  const Solid shaft = solid_of({cylinder_face(1, 0.0, 0.0, 0.02, 0.03, false),
                                cylinder_face(2, 0.0, 0.02, 0.08, 0.04, false),
                                cylinder_face(3, 0.0, 0.08, 0.1, 0.03, false)});
  EXPECT_EQ(found(shaft, joint_at(0.0, 0.01)), std::vector<int>{1});
  EXPECT_EQ(found(shaft, joint_at(0.0, 0.09)), std::vector<int>{3});
}

TEST(JointCylinder, FilletsAndArcsAreNoSeats) {
  const Solid corner =
      solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true, kPi / 2)});
  EXPECT_EQ(refusal(corner, joint_at(0.0, 0.005)).code(), "M017");
}

TEST(JointCylinder, TwoDiametersAreRefusedWithBoth) {
  const Solid stepped =
      solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true),
                cylinder_face(2, 0.0, 0.01, 0.02, 0.020, true)});
  const Error error = refusal(stepped, joint_at(0.0, 0.01));
  EXPECT_EQ(error.code(), "M017");
  EXPECT_EQ(error.place(), "scene.toml:7:1");
  EXPECT_NE(error.problem().find("diameter 16 mm, 10 mm long"),
            std::string::npos);
  EXPECT_NE(error.problem().find("diameter 20 mm, 10 mm long"),
            std::string::npos);
}

TEST(JointCylinder, ABoreBesideTheJointIsNotFoundButListed) {
  const Solid link = solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true)});
  for (const auto& joint : {joint_at(0.001, 0.005), joint_at(0.0, 0.03)}) {
    const Error error = refusal(link, joint);
    EXPECT_EQ(error.code(), "M017");
    EXPECT_NE(error.problem().find("no bore and no shaft"), std::string::npos);
    EXPECT_NE(error.problem().find("bore of diameter 16 mm"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace clevis::cad
