#include "calculix/bed_springs.h"

#include <cmath>
#include <functional>
#include <sstream>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "calculix/deck.h"
#include "support/simplex_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::calculix {
namespace {

using Eigen::Vector3d;

const part::Foundation kBed{.normal = 4e9, .tangential = 1e9};  // [N/m³]

const part::Material kSteel{.name = "steel",
                            .youngs_modulus = 210e9,
                            .poissons_ratio = 0.3,
                            .density = 7850.0,
                            .yield_strength = 355e6};

/// x0 of the unit cube leans by 45°: normal (−1, 0, −1)/√2, area √2.
Vector3d leaning(const Vector3d& x) {
  return {x.x() - x.z(), x.y(), x.z()};
}

/// Lies on a bed at x0 and is pulled up at x1.
Model bedded(const mesh::PartMesh<3>& mesh) {
  const Vector3d pull(0.0, 0.0, 1e6);
  loads::InstantLoad instant;
  instant.label = "pull";
  loads::SurfaceLoad load;
  load.group = "x1";
  load.traction = pull;
  load.resultant.force = 1.4142135623730951 * pull;
  load.resultant.moment = Vector3d(0.5, 0.5, 0.5).cross(load.resultant.force);
  load.total = load.resultant.force.norm();
  instant.surface_loads = {load};
  loads::LoadHistory history;
  history.instants = {instant};
  elasticity::ElasticProblem<3> problem{mesh, kSteel, history, {}, "block"};
  problem.foundations = {{"x0", kBed}};
  return make_model(problem, Hexahedron::kFull);
}

/// uᵀ F u of a field of displacement.
double twice_energy(const Model& model,
                    const std::function<Vector3d(const Vector3d&)>& field) {
  double sum = 0.0;
  for (const Spring& spring : model.springs) {
    const double here = field(model.nodes.col(spring.node))[spring.component];
    const double there =
        spring.other < 0
            ? 0.0
            : field(model.nodes.col(spring.other))[spring.other_component];
    sum += spring.stiffness * (here - there) * (here - there);
  }
  return sum;
}

class BedSprings : public testing::TestWithParam<mesh::CellShape> {
 protected:
  static mesh::PartMesh<3> block() {
    return GetParam() == mesh::CellShape::kTensor
               ? support::structured_mesh<3>({2, 3, 2}, 1, leaning)
               : support::simplex_mesh<3>({2, 3, 2}, 1, leaning);
  }
};

// u = c: A (k_n (n·c)² + k_t (|c|² − (n·c)²)).
TEST_P(BedSprings, RigidMotionsTakeTheBedsStiffness) {
  const Model model = bedded(block());
  const double area = std::sqrt(2.0);
  const Vector3d n = Vector3d(-1.0, 0.0, -1.0).normalized();
  for (const Vector3d& c : {Vector3d(1.0, 0.0, 0.0), Vector3d(0.3, -0.5, 0.8),
                            Vector3d(1.0, 0.0, -1.0)}) {
    const double across = n.dot(c) * n.dot(c);
    const double wanted = area * (kBed.normal * across +
                                  kBed.tangential * (c.squaredNorm() - across));
    EXPECT_NEAR(twice_energy(model,
                             [&](const Vector3d&) {
                               return c;
                             }),
                wanted, 1e-9 * kBed.normal);
  }
}

// u = y² n over y of [0, 1]: A k_n / 5, which no forces on nodes alone give.
TEST_P(BedSprings, FieldsOfTheElementsHaveTheirExactEnergy) {
  const Model model = bedded(block());
  const Vector3d n = Vector3d(-1.0, 0.0, -1.0).normalized();
  EXPECT_NEAR(twice_energy(model,
                           [&](const Vector3d& x) -> Vector3d {
                             return x.y() * x.y() * n;
                           }),
              std::sqrt(2.0) * kBed.normal / 5.0, 1e-9 * kBed.normal);
}

TEST_P(BedSprings, NothingElseIsHeld) {
  EXPECT_TRUE(bedded(block()).supports.empty());
}

// A bed that only carries across its face leaves the part free along it.
TEST_P(BedSprings, WhatABedLeavesFreeIsHeldAtNodes) {
  const mesh::PartMesh<3> mesh = block();
  loads::LoadHistory history;
  history.instants.resize(1);
  elasticity::ElasticProblem<3> problem{mesh, kSteel, history, {}, "block"};
  problem.foundations = {{"y0", {.normal = 1e9, .tangential = 0.0}}};
  EXPECT_EQ(make_model(problem, Hexahedron::kFull).supports.size(), 3U);
}

TEST_P(BedSprings, DeckNamesASetForEachStiffness) {
  const Model model = bedded(block());
  std::ostringstream out;
  write_deck(out, model);
  const std::string deck = out.str();
  EXPECT_NE(deck.find("*ELEMENT, TYPE=SPRING1, ELSET=SPRINGS_"),
            std::string::npos);
  EXPECT_NE(deck.find("*ELEMENT, TYPE=SPRING2, ELSET=SPRINGS_"),
            std::string::npos);
  EXPECT_EQ(deck.find("*BOUNDARY"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Cells, BedSprings,
                         testing::Values(mesh::CellShape::kTensor,
                                         mesh::CellShape::kSimplex),
                         [](const auto& tested) {
                           return tested.param == mesh::CellShape::kTensor
                                      ? "Hexahedra"
                                      : "Tetrahedra";
                         });

}  // namespace
}  // namespace clevis::calculix
