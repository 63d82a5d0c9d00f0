#include "assessment/job/part_zones.h"

#include <gtest/gtest.h>

#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

constexpr double kEdge = 0.02, kHeight = 0.01;  // [m]

PartJob block() {
  PartJob job;
  job.part.material = {"steel", 210e9, 0.3, 7850.0, 355e6};
  job.mesh = support::structured_mesh<3>(
      {3, 3, 3}, 1, [](const Vector3d& x) -> Vector3d {
        return {kEdge * x[0], kEdge * x[1], kHeight * x[2]};
      });
  return job;
}

// A bed that gives way by less than the part's smallest side is a support, by
// whichever of its stiffnesses is the larger.
TEST(PartZones, StiffBedsHaveTheEdgesOfSupports) {
  const PartJob job = block();
  const double limit = job.part.material.youngs_modulus / kHeight;
  const auto zones = [&](double normal, double tangential) {
    LoadSet set;
    set.foundations["z0"] = {normal, tangential};
    return part_zones<3>(job, job.mesh, set);
  };
  LoadSet clamped;
  clamped.fixed["z0"] = {true, true, true};
  const auto of_support = part_zones<3>(job, job.mesh, clamped);
  ASSERT_EQ(of_support.size(), 1u);
  for (const auto& [normal, tangential] :
       {std::pair{1.01 * limit, 0.0}, std::pair{0.0, 1.01 * limit}}) {
    const auto found = zones(normal, tangential);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].exponent, of_support[0].exponent);
    EXPECT_EQ(found[0].name, of_support[0].name);
  }
  EXPECT_TRUE(zones(0.99 * limit, 0.99 * limit).empty());
}

}  // namespace
}  // namespace clevis::assessment
