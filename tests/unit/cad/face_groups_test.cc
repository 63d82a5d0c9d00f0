#include "cad/face_groups.h"

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "cad/select_faces.h"
#include "solid_of_cylinders.h"

namespace clevis::cad {
namespace {

using Numbers = std::vector<int>;
using part::FaceSelector;

/// A block with four bores of two diameters and some planes.
Solid block() {
  return solid_of({cylinder_face(1, 0.01, 0.0, 0.01, 0.008, true),
                   cylinder_face(2, 0.05, 0.0, 0.01, 0.008, true),
                   cylinder_face(3, 0.09, 0.0, 0.01, 0.012, true),
                   plane_face(4, {0.0, 0.0, 0.01}, {0.0, 0.0, 1.0}),
                   plane_face(5, {0.05, 0.0, 0.01}, {0.0, 0.0, 1.0}),
                   plane_face(6, {0.05, 0.0, 0.02}, {0.0, 0.0, 1.0}),
                   plane_face(7, {0.05, 0.0, 0.0}, {0.0, 0.0, -1.0})});
}

/// The groups that one selector makes of the block; distances from a point are
/// those from the faces' centres.
FaceGroups groups(const FaceSelector& selector) {
  part::SolidSource source;
  source.faces = {{"wanted", selector}};
  const auto points = points_of(source);
  Solid solid = block();
  for (const auto& point : points) {
    solid.distances.emplace_back();
    for (const Face& face : solid.faces) {
      solid.distances.back().push_back((face.centre - point).norm());
    }
  }
  return face_groups(solid, points, source);
}

Numbers selected(const FaceSelector& selector) {
  return groups(selector).faces.at("wanted");
}

std::string refused(const FaceSelector& selector) {
  try {
    groups(selector);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "M017");
    EXPECT_EQ(error.place(), selector.place);
    return error.problem();
  }
  return "";
}

FaceSelector cylinder(std::optional<double> diameter,
                      std::optional<Eigen::Vector3d> near = {},
                      std::optional<Eigen::Vector3d> axis = {}) {
  return {part::CylinderSelector{diameter, near, axis}, "here"};
}

TEST(FaceGroups, TellCylindersByDiameterPlaceAndAxis) {
  EXPECT_EQ(selected(cylinder(0.012)), Numbers{3});
  EXPECT_EQ(selected(cylinder(0.008, Eigen::Vector3d(0.04, 0, 0))), Numbers{2});
  EXPECT_EQ(selected(cylinder({}, Eigen::Vector3d(0.08, 0, 0))), Numbers{3});
  EXPECT_NE(refused(cylinder(0.009)), "");
  EXPECT_NE(refused(cylinder(0.012, {}, Eigen::Vector3d(1, 0, 0))), "");
}

TEST(FaceGroups, TakeBothEarsOfAForkOrTheOneNearby) {
  Solid fork = solid_of({cylinder_face(1, 0.0, -0.02, -0.01, 0.016, true),
                         cylinder_face(2, 0.0, 0.01, 0.02, 0.016, true)});
  fork.distances = {{0.03, 0.01}};
  const Eigen::Vector3d near(0.0, 0.0, 0.022);
  EXPECT_EQ(select_faces(fork, {}, cylinder(0.016)), (Numbers{1, 2}));
  EXPECT_EQ(select_faces(fork, {near}, cylinder(0.016, near)), Numbers{2});
}

TEST(FaceGroups, RefuseTwoCylindersWithBoth) {
  const std::string several = refused(cylinder(0.008));
  EXPECT_NE(several.find("2 cylinders"), std::string::npos);
  EXPECT_NE(several.find("middle (10, 0, 5) mm"), std::string::npos);
  EXPECT_NE(several.find("middle (50, 0, 5) mm"), std::string::npos);
  // Half-way between both.
  EXPECT_NE(refused(cylinder(0.008, Eigen::Vector3d(0.03, 0, 0.005))), "");
}

TEST(FaceGroups, TakeAllFacesOfOnePlane) {
  const Eigen::Vector3d up(0, 0, 1);
  const FaceSelector top{part::PlaneSelector{up, Eigen::Vector3d(0, 0, 0.01)},
                         "here"};
  EXPECT_EQ(selected(top), (Numbers{4, 5}));
  EXPECT_EQ(selected({part::PlaneSelector{-up, {}}, "here"}), Numbers{7});
  EXPECT_NE(refused({part::PlaneSelector{up, {}}, "here"}), "");
  EXPECT_NE(refused({part::PlaneSelector{{1, 0, 0}, {}}, "here"}), "");
}

// Pads that stand 0.02 mm proud of their plate are no part of it.
TEST(FaceGroups, TellPlanesApartThatAreNear) {
  Solid padded = block();
  padded.faces[4].centre.z() += 2e-5;
  const auto taken = [&padded](double z) {
    return select_faces(
        padded, {},
        {part::PlaneSelector{{0, 0, 1}, Eigen::Vector3d(0, 0, z)}, "here"});
  };
  EXPECT_EQ(taken(0.01), Numbers{4});
  EXPECT_EQ(taken(0.01002), Numbers{5});
  EXPECT_THROW(taken(0.01001), Error);  // which is meant?
}

TEST(FaceGroups, TakeTheNearestFaceAndAllOfSeveral) {
  const FaceSelector nearest{part::NearestSelector{{0.05, 0.0, 0.019}}, "here"};
  EXPECT_EQ(selected(nearest), Numbers{6});
  EXPECT_EQ(selected({std::vector{nearest, cylinder(0.012), nearest}, "here"}),
            (Numbers{3, 6}));
}

TEST(FaceGroups, TellWhichDiametersThereAre) {
  EXPECT_EQ(refused(cylinder(0.0125)).find("unit"), std::string::npos);
  EXPECT_NE(refused(cylinder(0.0125)).find("bore of diameter 12 mm"),
            std::string::npos);
  for (const double factor : {1e3, 1e-3, 25.4, 1.0 / 25.4}) {
    EXPECT_NE(refused(cylinder(0.012 / factor)).find("is a unit wrong"),
              std::string::npos);
  }
}

TEST(FaceGroups, TakeTheFaceOfALabelAndListOthers) {
  Solid named = block();
  named.faces[2].label = "PIN";
  named.faces[3].label = named.faces[4].label = "TOP";
  const auto take = [&named](const char* label) {
    return select_faces(named, {}, {part::LabelSelector{label}, "here"});
  };
  const auto problem = [&take](const char* label) {
    try {
      take(label);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "M017");
      return error.problem();
    }
    return std::string();
  };
  EXPECT_EQ(take("PIN"), Numbers{3});
  EXPECT_EQ(problem("TOP"), "the faces 4 5 bear the label \"TOP\"");
  EXPECT_EQ(problem("pin"),
            "no face bears the label \"pin\"; there are \"PIN\" of face 3, "
            "\"TOP\" of face 4, \"TOP\" of face 5");
  named = block();
  EXPECT_EQ(problem("PIN"),
            "no face of the part bears a label; those of STEP files may");
}

TEST(FaceGroups, TellWhichEarOfAForkIsLeftOut) {
  const Solid fork = solid_of({cylinder_face(1, 0.0, -0.02, -0.01, 0.016, true),
                               cylinder_face(2, 0.0, 0.01, 0.02, 0.016, true)});
  Solid seen = fork;
  const Eigen::Vector3d near(0.0, 0.0, 0.022);
  seen.distances = {{0.04, 0.01}};
  part::SolidSource source;
  source.faces = {{"a", cylinder(0.016, near)}};
  const FaceGroups one = face_groups(seen, {near}, source);
  ASSERT_EQ(one.told.size(), 1u);
  EXPECT_NE(one.told[0].find("face 1 is on the same axis"), std::string::npos)
      << one.told[0];
  source.faces = {{"a", cylinder(0.016)}};
  EXPECT_TRUE(face_groups(fork, {}, source).told.empty());
}

TEST(FaceGroups, KeepAFaceToOneGroup) {
  part::SolidSource source;
  source.faces = {{"a", cylinder(0.012)}, {"b", cylinder(0.012)}};
  try {
    face_groups(block(), {}, source);
    FAIL() << "face 3 is in two groups";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "M012");
  }
}

TEST(FaceGroups, MakeRoundsOfTheOtherCylinders) {
  FaceGroups found = groups(cylinder(0.012));
  add_rounds(block(), found);
  EXPECT_EQ(found.faces.size(), 3u);
  EXPECT_EQ(found.faces.at("round_1"), Numbers{1});
  EXPECT_EQ(found.faces.at("round_2"), Numbers{2});
}

}  // namespace
}  // namespace clevis::cad
