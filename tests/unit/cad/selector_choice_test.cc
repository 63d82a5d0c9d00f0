#include "cad/selector_choice.h"

#include <string>

#include <gtest/gtest.h>

#include "solid_of_cylinders.h"

namespace clevis::cad {
namespace {

using Eigen::Vector3d;

/// A solid of bores along z, each in pieces of 10 mm about x and two heights,
/// with the distances of points on axes.
struct Forks {
  Solid solid;
  std::vector<PinBore> bores;
  std::vector<Vector3d> points;

  explicit Forks(std::vector<Face> faces) : solid(solid_of(std::move(faces))) {
    bores = pin_bores(solid);
    std::vector<SelectorChoice> choices;
    for (const PinBore& bore : bores) choices.push_back(choice_of(bore));
    points = points_of(choices);
    for (const Vector3d& point : points) {
      std::vector<double> row;
      for (const Face& face : solid.faces) {
        const Vector3d away = point - face.axis_point;
        const double beside = Vector3d(away.x(), away.y(), 0).norm();
        const double along =
            std::max({0.0, face.low - away.z(), away.z() - face.high});
        row.push_back(std::hypot(std::abs(beside - face.radius), along));
      }
      solid.distances.push_back(row);
    }
  }

  std::string text(std::size_t bore) const {
    const auto found = chosen(solid, points, choice_of(bores.at(bore)));
    return found ? toml_text(*found) : "none";
  }
};

TEST(SelectorChoice, SaysNoMoreThanItTakes) {
  const Forks one({cylinder_face(1, 0.0, 0.0, 0.01, 0.02, true),
                   cylinder_face(2, 0.05, 0.0, 0.01, 0.012, true)});
  EXPECT_EQ(one.text(0), "{ cylinder = { diameter = \"20 mm\" } }");
  EXPECT_EQ(one.text(1), "{ cylinder = { diameter = \"12 mm\" } }");
  const Forks equal({cylinder_face(1, 0.0, 0.0, 0.01, 0.02, true),
                     cylinder_face(2, 0.05, 0.0, 0.01, 0.02, true)});
  EXPECT_EQ(equal.text(1),
            "{ cylinder = { diameter = \"20 mm\", near = [\"50 mm\", \"0 mm\", "
            "\"5 mm\"] } }");
}

TEST(SelectorChoice, NamesEachEarOfForksThatAreAlike) {
  std::vector<Face> faces;
  int number = 0;
  for (const double x : {0.0, 0.05}) {
    for (const double z : {0.0, 0.03}) {
      faces.push_back(cylinder_face(++number, x, z, z + 0.01, 0.02, true));
    }
  }
  const Forks forks(faces);
  ASSERT_EQ(forks.bores.size(), 2u);
  EXPECT_EQ(forks.text(0).substr(0, 12), "{ all_of = [");
  EXPECT_NE(forks.text(1).find("\"35 mm\""), std::string::npos);
}

TEST(SelectorChoice, PlanesByNormalOrPlace) {
  const Vector3d z = Vector3d::UnitZ();
  Solid solid = solid_of({plane_face(1, {0, 0, 0.02}, z)});
  EXPECT_EQ(toml_text(*chosen(solid, {}, choice_of(solid.faces[0]))),
            "{ plane = { normal = [0, 0, 1] } }");
  solid = solid_of(
      {plane_face(1, {0, 0, 0.02}, z), plane_face(2, {0, 0, 0.05}, z)});
  EXPECT_EQ(toml_text(*chosen(solid, {}, choice_of(solid.faces[1]))),
            "{ plane = { normal = [0, 0, 1], through = [\"0 mm\", \"0 mm\", "
            "\"50 mm\"] } }");
}

TEST(SelectorChoice, AxesHaveTheDigitsThatJointsNeed) {
  const Vector3d axis = Vector3d(1, 2, -3).normalized();
  EXPECT_EQ(components(axis), "0.267261242, 0.534522484, -0.801783726");
  EXPECT_EQ(components(Vector3d(-1e-17, 0, 1)), "0, 0, 1");
}

}  // namespace
}  // namespace clevis::cad
