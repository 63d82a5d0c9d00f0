#include "cad/exchange.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "solid_of_cylinders.h"

namespace clevis::cad {
namespace {

TEST(Exchange, BringsARequestAcross) {
  Request request;
  request.file = "/tmp/a part.igs";
  request.format = part::GeometryFormat::kIges;
  request.length_unit = 0.0254;
  request.points = {{0.1, 1.0 / 3.0, -2e-9}};
  request.facets = true;
  request.mesh = "/tmp/part.msh";
  request.groups = {{"bore_A", {3, 4}}, {"foot", {1}}};
  request.mesh_size = 0.004;
  request.plate = {3, 7, 0.008, {0.6, 0.0, 0.8}};
  request.finer = {1.5, {{{0.1, 0.2, 0.3}, 2.5}}};
  const Request read = read_request(text_of(request));
  EXPECT_EQ(read.file, request.file);
  EXPECT_EQ(read.format, request.format);
  EXPECT_EQ(read.length_unit, request.length_unit);
  EXPECT_EQ(read.points, request.points);
  EXPECT_TRUE(read.facets);
  EXPECT_EQ(read.mesh, request.mesh);
  EXPECT_EQ(read.groups, request.groups);
  EXPECT_EQ(read.mesh_size, request.mesh_size);
  EXPECT_EQ(read.finer.everywhere, request.finer.everywhere);
  ASSERT_EQ(read.finer.at.size(), 1U);
  EXPECT_EQ(read.finer.at[0].at, request.finer.at[0].at);
  EXPECT_EQ(read.finer.at[0].times, request.finer.at[0].times);
  ASSERT_TRUE(read.plate);
  EXPECT_EQ(read.plate->bottom, 3);
  EXPECT_EQ(read.plate->top, 7);
  EXPECT_EQ(read.plate->thickness, 0.008);
  EXPECT_EQ(read.plate->normal, Eigen::Vector3d(0.6, 0.0, 0.8));
  request.mesh_size.reset();
  request.plate.reset();
  EXPECT_FALSE(read_request(text_of(request)).mesh_size);
  EXPECT_FALSE(read_request(text_of(request)).plate);
}

TEST(Exchange, BringsASolidAcross) {
  Solid solid = solid_of({cylinder_face(1, 0.04, -0.01, 0.02, 0.016, true),
                          plane_face(2, {1, 2, 3}, {0, 0, -1})});
  solid.unit = "INCH";
  solid.volume = 7e-5;
  solid.distances = {{0.25, 0.5}};
  solid.faces[0].neighbours = {2};
  solid.faces[1].label = "TOP \"1\"";
  solid.facets = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}}}, {}};
  const Solid read = read_answer(answer(solid));
  EXPECT_EQ(read.unit, "INCH");
  EXPECT_EQ(read.volume, solid.volume);
  EXPECT_EQ(read.high, solid.high);
  EXPECT_EQ(read.distances, solid.distances);
  ASSERT_EQ(read.faces.size(), 2u);
  EXPECT_EQ(read.faces[0].kind, SurfaceKind::kCylinder);
  EXPECT_EQ(read.faces[0].radius, 0.008);
  EXPECT_TRUE(read.faces[0].hollow);
  EXPECT_EQ(read.faces[0].low, -0.01);
  EXPECT_EQ(read.faces[0].neighbours, std::vector<int>{2});
  EXPECT_EQ(read.faces[1].normal, solid.faces[1].normal);
  EXPECT_EQ(read.faces[0].label, "");
  EXPECT_EQ(read.faces[1].label, "TOP \"1\"");
  ASSERT_EQ(read.facets.size(), 2U);
  EXPECT_EQ(read.facets[0].points, solid.facets[0].points);
  EXPECT_EQ(read.facets[0].triangles, solid.facets[0].triangles);
  // A corner that is no point would be read beyond the points.
  solid.facets[0].triangles = {{0, 1, 3}};
  EXPECT_THROW(read_answer(answer(solid)), std::runtime_error);
}

TEST(Exchange, BringsARefusalAcross) {
  try {
    read_answer(refusal("M016", "a.step", "two solids", "Join them."));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "M016");
    EXPECT_EQ(error.problem(), "two solids");
    EXPECT_EQ(error.remedy(), "Join them.");
  }
  EXPECT_ANY_THROW(read_answer("not JSON"));
  EXPECT_ANY_THROW(read_answer("{}"));
}

}  // namespace
}  // namespace clevis::cad
