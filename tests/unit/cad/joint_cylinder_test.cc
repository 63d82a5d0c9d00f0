#include "cad/joint_cylinder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "solid_of_cylinders.h"

namespace clevis::cad {
namespace {

using Eigen::Vector3d;

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

TEST(JointCylinder, TellsHowFarTheNearestAreOff) {
  std::vector<Face> faces{cylinder_face(1, 0.01, 0.0, 0.01, 0.03, false),
                          cylinder_face(2, 0.06, 0.0, 0.01, 0.016, true),
                          cylinder_face(3, 0.012, 0.0, 0.01, 0.016, true),
                          cylinder_face(4, 0.01, 0.0, 0.01, 0.02, true, kPi)};
  faces.push_back(cylinder_face(5, 0.01, 0.0, 0.01, 0.018, true));
  faces.back().axis = Vector3d(0.0, std::sin(0.1), std::cos(0.1));
  const std::string problem =
      refusal(solid_of(faces), joint_at(0.01, 0.025)).problem();
  const auto at = [&](const char* text) {
    EXPECT_NE(problem.find(text), std::string::npos) << text << problem;
    return problem.find(text);
  };
  // 2 mm beside and 15 mm beyond, then 0.1 rad, then 50 mm beside.
  EXPECT_LT(at("face 3 (its axis 2 mm from the point, its end 15 mm off along "
               "it)"),
            at("face 5 (its axis turned by 5.73 deg"));
  EXPECT_LT(at("face 5 (its axis turned"), at("face 2 (its axis 50 mm"));
  EXPECT_LT(at("face 2"), at("face 1 (its end 15 mm off along it)"));
  at("face 4 (its end 15 mm off along it, only 180 deg of a turn)");
  EXPECT_EQ(problem.find("unit"), std::string::npos);
}

TEST(JointCylinder, SuspectsAUnitThatIsWrong) {
  const Solid link = solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.016, true),
                               cylinder_face(2, 0.08, 0.0, 0.01, 0.016, true)});
  for (const double ratio : {1000.0, 25.4}) {
    for (const double factor : {ratio, 1.0 / ratio}) {
      const Error error =
          refusal(link, joint_at(0.08 / factor, 0.005 / factor));
      EXPECT_NE(error.remedy().find("A unit seems wrong"), std::string::npos)
          << factor << error.problem();
      EXPECT_NE(error.remedy().find(ratio > 100.0 ? "1000 mm" : "25.4 mm"),
                std::string::npos);
    }
  }
  // On the axis of a bore at the origin every factor would fit along it.
  EXPECT_EQ(refusal(link, joint_at(0.0, 2.0)).remedy().find("unit"),
            std::string::npos);
}

}  // namespace
}  // namespace clevis::cad
