#include "mesh/gmsh/gmsh_file.h"

#include <chrono>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mesh/gmsh/gmsh_reader.h"
#include "mesh/reading/cells.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

const std::array<std::string, 4> kVariants = {
    "plate_with_bore_22.msh", "plate_with_bore_22_binary.msh",
    "plate_with_bore_41.msh", "plate_with_bore_41_binary.msh"};

/// ASCII files carry 16 digits: one unit in the last of 20 mm.
constexpr double kDigits = 4e-18;

void expect_same(const PartMesh<3>& a, const PartMesh<3>& b) {
  EXPECT_EQ(a.degree, b.degree);
  EXPECT_EQ(a.cells, b.cells);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    EXPECT_LE((a.vertices[v] - b.vertices[v]).norm(), 4 * kDigits);
  }
  ASSERT_EQ(a.cell_points.size(), b.cell_points.size());
  for (std::size_t c = 0; c < a.cell_points.size(); ++c) {
    EXPECT_LE((a.cell_points[c] - b.cell_points[c]).cwiseAbs().maxCoeff(),
              16 * kDigits);
  }
  ASSERT_EQ(a.boundary.size(), b.boundary.size());
  for (std::size_t f = 0; f < a.boundary.size(); ++f) {
    EXPECT_EQ(a.boundary[f].cell, b.boundary[f].cell);
    EXPECT_EQ(a.boundary[f].face, b.boundary[f].face);
    EXPECT_EQ(a.boundary[f].group, b.boundary[f].group);
  }
  ASSERT_EQ(a.groups.size(), b.groups.size());
  for (std::size_t g = 0; g < a.groups.size(); ++g) {
    EXPECT_EQ(a.groups[g].name, b.groups[g].name);
  }
}

TEST(GmshFile, AllVariantsOfTheFormatGiveTheSameMesh) {
  const PartMesh<3> first = read(kVariants[0]);
  EXPECT_EQ(first.cells.size(), 64u);
  EXPECT_EQ(first.vertices.size(), 144u);
  ASSERT_EQ(first.groups.size(), 4u);
  EXPECT_EQ(first.groups[0].name, "bore_A");
  for (std::size_t i = 1; i < kVariants.size(); ++i) {
    SCOPED_TRACE(kVariants[i]);
    expect_same(first, read(kVariants[i]));
  }
}

TEST(GmshFile, GroupsHoldTheirFaces) {
  const PartMesh<3> mesh = read(kVariants[2]);
  std::map<int, int> faces;
  for (const auto& face : mesh.boundary) ++faces[face.group];
  EXPECT_EQ(faces[group_index(mesh, "bore_A")], 32);  // 16 around, 2 layers
  EXPECT_EQ(faces[group_index(mesh, "top")], 32);
  EXPECT_EQ(faces[group_index(mesh, "right")], 8);
  EXPECT_EQ(faces[group_index(mesh, "left")], 8);
  EXPECT_EQ(faces[-1], 16 + 32);  // front and back, bottom
}

TEST(GmshFile, TagsMayBeSparseAndUnsorted) {
  constexpr const char* kText =
      "$MeshFormat\r\n2.2 0 8\r\n$EndMeshFormat\r\n"
      "$Comments\nfree text: SystemCall \"touch x\";\n$EndComments\n"
      "$Nodes\n4\n900 0 0 1\n7 0 0 0\n+12 1e0 0 0\n30 0 1 0\n$EndNodes\n"
      "$Elements\n1\n5 4 0 7 12 30 900\n$EndElements\n";
  const GmshFile file = parse_gmsh(kText, "text");
  EXPECT_EQ(file.node_tags, (std::vector<std::uint64_t>{7, 12, 30, 900}));
  EXPECT_EQ(file.element_nodes, (std::vector<unsigned>{0, 1, 2, 3}));
  EXPECT_EQ(file.points[3], Eigen::Vector3d(0, 0, 1));
}

TEST(GmshFile, EveryTruncationIsRefused) {
  for (const std::string& name : kVariants) {
    const std::string whole = bytes_of(data(name));
    const std::size_t end = whole.find("$EndElements");
    for (std::size_t size = 0; size < end; size += 97) {
      EXPECT_THROW(parse_gmsh(std::string_view(whole).substr(0, size), name),
                   Error)
          << name << " cut to " << size;
    }
  }
}

TEST(GmshFile, RandomDamageGivesAnErrorOrAMeshButNeverACrash) {
  std::mt19937 random(20261121);
  for (const std::string& name : kVariants) {
    const std::string whole = bytes_of(data(name));
    int refused = 0;
    for (int trial = 0; trial < 500; ++trial) {
      std::string damaged = whole;
      for (auto flips = random() % 3 + 1; flips > 0; --flips) {
        damaged[random() % damaged.size()] ^= char(1u << random() % 8);
      }
      if (trial % 5 == 0) damaged.resize(random() % damaged.size());
      try {
        build_cells(parse_gmsh(damaged, name), 1e-3);
      } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::kMeshInvalid) << error.what();
        ++refused;
      }
    }
    EXPECT_GT(refused, 100) << name;
  }
}

TEST(GmshFile, OneMegabyteIsReadInTenMilliseconds) {
  // 16 000 nodes with 16 digits, about 1 MB; the limit leaves room for a busy
  // machine and for unoptimised builds.
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n16000\n";
  for (int i = 1; i <= 16000; ++i) {
    text += std::to_string(i) + " 0.1234567890123456 -12.34567890123456 " +
            std::to_string(i) + ".4567890123456\n";
  }
  text += "$EndNodes\n$Elements\n0\n$EndElements\n";
  double best = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    const GmshFile file = parse_gmsh(text, "text");
    const std::chrono::duration<double> seconds =
        std::chrono::steady_clock::now() - start;
    best = std::min(best, seconds.count());
    ASSERT_EQ(file.points.size(), 16000u);
  }
  RecordProperty("ms_per_MB", std::to_string(1e3 * best));
#ifdef NDEBUG
  EXPECT_LT(best, 0.010);
#endif
}

}  // namespace
}  // namespace clevis::mesh
