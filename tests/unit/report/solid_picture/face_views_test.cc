#include "report/solid_picture/face_views.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "report/solid_picture/digits.h"
#include "report/solid_picture/face_picture.h"

namespace clevis::report {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kWidth = 400;  // of a view [pixel]

/// A rectangle with a corner and two sides [mm].
DrawnFace rectangle(int number, const Vector3d& corner, const Vector3d& first,
                    const Vector3d& second) {
  DrawnFace face;
  face.number = number;
  face.points.resize(4, 3);
  face.points.row(0) = corner;
  face.points.row(1) = corner + first;
  face.points.row(2) = corner + first + second;
  face.points.row(3) = corner + second;
  face.triangles = {{0, 1, 2}, {0, 2, 3}};
  return face;
}

/// The six faces of a box, numbered from `first` on.
void add_box(int first, const Vector3d& low, const Vector3d& size,
             std::vector<DrawnFace>& faces) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d a = size[(axis + 1) % 3] * Vector3d::Unit((axis + 1) % 3);
    const Vector3d b = size[(axis + 2) % 3] * Vector3d::Unit((axis + 2) % 3);
    const Vector3d up = size[axis] * Vector3d::Unit(axis);
    faces.push_back(rectangle(first++, low, b, a));
    faces.push_back(rectangle(first++, low + up, a, b));
  }
}

std::vector<DrawnFace> box() {
  std::vector<DrawnFace> faces;
  add_box(1, {0, 0, 0}, {60, 30, 20}, faces);
  return faces;
}

/// Whether the dot of a number lies on its rectangle.
bool is_on(const FaceNumber& number, const FaceView& view,
           const DrawnFace& face) {
  const auto at = [&](int corner) -> Vector2d {
    return view.placement.at(face.points.row(corner).transpose());
  };
  Eigen::Matrix2d sides;
  sides << at(1) - at(0), at(3) - at(0);
  const Vector2d share = sides.inverse() * (number.dot - at(0));
  return share.minCoeff() > 0.0 && share.maxCoeff() < 1.0;
}

std::set<int> numbers_of(const FaceViews& views) {
  std::set<int> numbers;
  for (const FaceView& view : views.views) {
    for (const FaceNumber& number : view.numbers) numbers.insert(number.number);
  }
  return numbers;
}

TEST(FaceViews, TwoShowTheSixFacesOfABox) {
  const auto faces = box();
  const FaceViews found = face_views(faces, kWidth);
  ASSERT_EQ(found.views.size(), 2U);
  EXPECT_TRUE(found.hidden.empty());
  EXPECT_EQ(numbers_of(found), (std::set{1, 2, 3, 4, 5, 6}));
  for (const FaceView& view : found.views) {
    EXPECT_EQ(view.numbers.size(), 3U);  // those that look this way
    for (const FaceNumber& number : view.numbers) {
      const auto& face = faces[static_cast<std::size_t>(number.number) - 1];
      EXPECT_TRUE(is_on(number, view, face)) << number.number;
      EXPECT_EQ(number.at, number.dot) << number.number;
    }
  }
  // From opposite sides.
  const auto eye = [&](std::size_t v) -> Vector3d {
    return found.views[v].placement.sight.row(2);
  };
  EXPECT_NEAR(eye(0).dot(eye(1)), -1.0, 1e-12);
}

TEST(FaceViews, AFaceTooSmallForItsNumberHasOneBesideIt) {
  auto faces = box();
  for (int n = 0; n < 12; ++n) {  // patches of 1 mm on the top
    faces.push_back(
        rectangle(101 + n, {20.0 + 1.5 * n, 15, 20.01}, {1, 0, 0}, {0, 1, 0}));
  }
  const FaceViews found = face_views(faces, kWidth);
  EXPECT_EQ(numbers_of(found).size(), faces.size());
  for (const FaceView& view : found.views) {
    for (std::size_t i = 0; i < view.numbers.size(); ++i) {
      const FaceNumber& one = view.numbers[i];
      const auto face =
          std::ranges::find(faces, one.number, &DrawnFace::number);
      EXPECT_TRUE(is_on(one, view, *face)) << one.number;
      EXPECT_EQ(one.number > 100, (one.at - one.dot).norm() > 1.0);
      const Vector2d half = half_size(std::to_string(one.number).size());
      EXPECT_GE((one.at - half).minCoeff(), 0.0);
      EXPECT_LE(one.at.x() + half.x(), view.width);
      EXPECT_LE(one.at.y() + half.y(), view.height);
      for (std::size_t k = 0; k < i; ++k) {
        const FaceNumber& other = view.numbers[k];
        const Vector2d gap = (one.at - other.at).cwiseAbs() - half -
                             half_size(std::to_string(other.number).size());
        EXPECT_GE(gap.maxCoeff(), 0.0) << one.number << " " << other.number;
      }
    }
  }
}

/// A box with a slot that opens to one side only, away from both first views.
TEST(FaceViews, FurtherViewsShowWhatTheFirstTwoDoNot) {
  auto faces = box();
  // Two walls before the face at low y: what is between them is seen from
  // straight ahead only.
  faces.push_back(rectangle(7, {0, -40, 0}, {0, 0, 20}, {0, 39.99, 0}));
  faces.push_back(rectangle(8, {0, -40, -0.01}, {60, 0, 0}, {0, 39.99, 0}));
  faces.push_back(rectangle(9, {60, -40, 0}, {0, 0, 20}, {0, 39.99, 0}));
  faces.push_back(rectangle(10, {0, -40, 20.01}, {60, 0, 0}, {0, 39.99, 0}));
  const FaceViews found = face_views(faces, kWidth);
  EXPECT_GT(found.views.size(), 2U);
  EXPECT_EQ(numbers_of(found).size(), faces.size());
  EXPECT_TRUE(found.hidden.empty());
}

TEST(FaceViews, WallsOfACavityAreToldAsHidden) {
  auto faces = box();
  add_box(7, {20, 10, 5}, {10, 5, 5}, faces);
  const FaceViews found = face_views(faces, kWidth);
  EXPECT_EQ(found.hidden, (std::vector{7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(numbers_of(found).size(), 6U);
  const std::string svg = face_picture_svg(found, faces, "box");
  EXPECT_NE(svg.find("no view shows 7 8 9 10 11 12"), std::string::npos);
}

TEST(FacePicture, WritesEveryNumberAndGroup) {
  auto faces = box();
  faces[3].group = "tip & <root>";
  const FaceViews views = face_views(faces, kWidth);
  const std::string svg = face_picture_svg(views, faces, "box");
  for (int number = 1; number <= 6; ++number) {
    EXPECT_NE(svg.find(">" + std::to_string(number) + "</text>"),
              std::string::npos);
  }
  EXPECT_NE(svg.find("tip &amp; &lt;root&gt;: 4"), std::string::npos);
  EXPECT_EQ(face_picture_png(views).substr(1, 3), "PNG");
}

TEST(Canvas, WritesDigitsThatDiffer) {
  std::set<std::vector<std::uint8_t>> seen;
  for (const char sign : std::string("0123456789xyz")) {
    Canvas canvas(40, 40);
    canvas.write(std::string(1, sign), {20, 20});
    EXPECT_TRUE(seen.insert(canvas.rgb).second) << sign;
    EXPECT_GT(std::ranges::count(canvas.rgb, 0), 3 * 4 * 7) << sign;
  }
  Canvas corner(8, 8);  // what leaves the picture is cut
  corner.write("88", {0, 0});
  corner.line({-5, -5}, {20, 20});
  EXPECT_EQ(corner.rgb.size(), 3U * 64U);
}

}  // namespace
}  // namespace clevis::report
