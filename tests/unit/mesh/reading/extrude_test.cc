#include "mesh/reading/extrude.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mesh/derived/plate.h"
#include "mesh/gmsh/gmsh_reader.h"
#include "mesh/quality/mass_properties.h"
#include "mesh/quality/mesh_validation.h"
#include "mesh/reading/cells.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;
constexpr double kThickness = 8e-3;

PartMesh<3> plate(const std::string& name) {
  return read_part_mesh(data(name), 1e-3, kThickness);
}

double length_of(const PartMesh<2>& mesh, const std::string& name) {
  double length = 0.0;
  for (const BoundaryFace& face : mesh.boundary) {
    if (mesh.groups[std::size_t(face.group)].name != name) continue;
    const auto& cell = mesh.cells[std::size_t(face.cell)];
    const unsigned a = cell[std::size_t(face.face)];
    const unsigned b = cell[std::size_t((face.face + 1) % 3)];
    length += (mesh.vertices[a] - mesh.vertices[b]).norm();
  }
  return length;
}

TEST(Extrude, FlatRingsBecomePlatesOfTheirThickness) {
  const double volume = kPi * 300e-6 * kThickness;
  for (const char* type : {"tri3", "tri6", "quad4", "quad8", "quad9"}) {
    SCOPED_TRACE(type);
    const bool curved = std::string(type) != "tri3" && type[4] != '4';
    const PartMesh<3> mesh = plate(std::string("ring_flat_") + type + ".msh");
    const auto mass = mass_properties(mesh, 7850.0);
    // The bore is exact, the rim as curved as the file; in flat facets it is
    // taken for its cylinder.
    const double want = 7850.0 * volume;
    EXPECT_NEAR(mass.mass, want, (curved ? 1e-4 : 1e-7) * want);
    EXPECT_LT((mass.p_LCm - Vector3d(3e-3, 4e-3, 5e-3)).norm(), 1e-12);
    const int bore = group_index(mesh, "bore_A");
    ASSERT_GE(bore, 0);
    const auto& cylinder = mesh.groups[std::size_t(bore)].cylinder.value();
    EXPECT_NEAR(cylinder.radius, 10e-3, 1e-13);
    EXPECT_NEAR(cylinder.length, kThickness, 1e-13);
    EXPECT_EQ(cylinder.axis_L, Vector3d::UnitZ());
    const double wall = 2.0 * kPi * 10e-3 * kThickness;
    EXPECT_NEAR(face_properties(mesh, bore).area, wall, 1e-7 * wall);
    ASSERT_EQ(mesh.groups.size(), 2u);
  }
}

TEST(Extrude, TheMidPlaneIsFoundAgain) {
  for (const char* type : {"tri3", "tri6", "quad4", "quad8", "quad9"}) {
    SCOPED_TRACE(type);
    const PartMesh<3> solid = plate(std::string("ring_flat_") + type + ".msh");
    const auto flat = plate_mid_plane(solid);
    ASSERT_TRUE(flat);
    const bool triangles = type[0] == 't';
    EXPECT_EQ(flat->shape,
              triangles ? CellShape::kSimplex : CellShape::kTensor);
    EXPECT_EQ(flat->cells.size(), triangles ? 64u : 32u);
    EXPECT_NEAR(flat->thickness, kThickness, 1e-15);
    EXPECT_NEAR(flat->mid_plane_z, 5e-3, 1e-15);
    ASSERT_EQ(flat->groups.size(), 2u);
    EXPECT_EQ(flat->boundary.size(), 32u);
    const auto thin = mass_properties(*flat, 7850.0);
    const auto thick = mass_properties(solid, 7850.0);
    // Tetrahedra meet the cylinder once more within the thickness.
    const double apart = triangles ? 1e-7 : 1e-12;
    EXPECT_NEAR(thin.mass, thick.mass, apart * thick.mass);
    EXPECT_LT((thin.p_LCm - thick.p_LCm).norm(), apart);
    EXPECT_LT((thin.inertia_LCm - thick.inertia_LCm).norm(),
              apart * thick.inertia_LCm.norm());
    if (triangles) {
      EXPECT_NEAR(length_of(*flat, "bore_A"), 32 * 10e-3 * std::sin(kPi / 16),
                  1e-12);
    }
  }
}

TEST(Extrude, TheSenseOfRotationDoesNotMatter) {
  for (const char* name : {"ring_flat_tri6.msh", "ring_flat_quad8.msh"}) {
    GmshFile file = read_gmsh_file(data(name));
    const auto mass = [](const GmshFile& flat) {
      const PartMesh<3> mesh = build_cells(extrude(flat, 8.0), 1e-3);
      check_jacobians(mesh, flat.name);
      return mass_properties(mesh, 1.0).mass;
    };
    const double want = mass(file);
    for (auto& p : file.points) p.x() = -p.x();  // now all clockwise
    EXPECT_NEAR(mass(file), want, 1e-13 * want);
  }
}

std::string code_of(const GmshFile& file) {
  try {
    extrude(file, 8.0);
  } catch (const Error& error) {
    return std::string(error.code());
  }
  return "";
}

TEST(Extrude, RefusesWhatIsNoPlate) {
  const GmshFile good = read_gmsh_file(data("ring_flat_tri6.msh"));
  EXPECT_TRUE(is_flat(good));
  EXPECT_FALSE(is_flat(read_gmsh_file(data("ring.msh"))));
  EXPECT_EQ(code_of(good), "");
  GmshFile bumpy = good;
  bumpy.points[20].z() += 1e-3;
  EXPECT_EQ(code_of(bumpy), "M013");
  GmshFile folded = good;  // a corner beyond its neighbours
  folded.points[0] = {30.0, 30.0, 5.0};
  EXPECT_EQ(code_of(folded), "M005");
  EXPECT_THROW(read_part_mesh(data("ring.msh"), 1e-3, 8e-3), Error);
  EXPECT_THROW(read_part_mesh(data("ring_flat_tri3.msh"), 1e-3), Error);
}

}  // namespace
}  // namespace clevis::mesh
