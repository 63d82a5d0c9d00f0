#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "support/source_dir.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

const std::filesystem::path kFolder =
    support::source_dir() / "tests/invalid/mesh";

/// What a case says in its first line: # expect: M005 11 "text".
struct Expectation {
  std::string code, text;
  int exit_code{};
};

Expectation expectation(const std::filesystem::path& scene) {
  std::ifstream stream(scene);
  Expectation e;
  std::string word;
  stream >> word >> word >> e.code >> e.exit_code;
  std::getline(stream, word, '"');
  std::getline(stream, e.text, '"');
  return e;
}

double length_unit(const std::filesystem::path& scene) {
  return bytes_of(scene).find("length_unit = \"m\"") == std::string::npos ? 1e-3
                                                                          : 1.0;
}

std::optional<double> thickness(const std::filesystem::path& scene) {
  const std::string text = bytes_of(scene);
  if (text.find("thickness = \"8 mm\"") != std::string::npos) return 8e-3;
  if (text.find("thickness = \"10 m\"") != std::string::npos) return 10.0;
  return std::nullopt;
}

TEST(InvalidMesh, EachIsRefusedWithItsCodeWithinASecond) {
  int cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".toml") continue;
    const Expectation expected = expectation(entry.path());
    // The mesh is fine, the scene not.
    if (expected.code == "M003" ||
        entry.path().stem() == "refined_tetrahedra") {
      continue;
    }
    SCOPED_TRACE(entry.path().filename().string());
    auto file = entry.path();
    file.replace_extension(".msh");
    const auto start = std::chrono::steady_clock::now();
    try {
      read_part_mesh(file, length_unit(entry.path()), thickness(entry.path()));
      ADD_FAILURE() << "was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), expected.code) << error.what();
      EXPECT_EQ(int(error.exit_code()), expected.exit_code);
      const std::string all =
          error.place() + ": " + error.problem() + "; " + error.remedy();
      EXPECT_NE(all.find(expected.text), std::string::npos) << all;
      EXPECT_NE(error.place().find(file.stem().string()), std::string::npos);
      EXPECT_FALSE(error.remedy().empty());
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start,
              std::chrono::seconds(1));
    ++cases;
  }
  EXPECT_GE(cases, 20);
}

TEST(InvalidMesh, TrianglesAmongQuadranglesHaveARemedyInGmsh) {
  try {
    read_part_mesh(kFolder / "flat_mixed.msh", 1e-3, 8e-3);
    ADD_FAILURE() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(error.remedy().find("Mesh.SubdivisionAlgorithm = 1"),
              std::string::npos)
        << error.remedy();
  }
}

TEST(InvalidMesh, AScriptInAMeshRunsNothing) {
  for (const char* name : {"script_as_mesh.msh", "script_after_header.msh"}) {
    EXPECT_NE(bytes_of(kFolder / name).find("touch script_ran"),
              std::string::npos);
    EXPECT_THROW(read_part_mesh(kFolder / name, 1e-3), Error);
  }
  EXPECT_FALSE(std::filesystem::exists("script_ran"));
  EXPECT_FALSE(std::filesystem::exists(kFolder / "script_ran"));
}

TEST(InvalidMesh, TheCaseOfTheMissingGroupHasAGoodMesh) {
  const PartMesh<3> mesh = read_part_mesh(kFolder / "missing_group.msh", 1e-3);
  EXPECT_EQ(mesh.cells.size(), 4u);
  EXPECT_EQ(group_index(mesh, "tap"), -2);
  EXPECT_GE(group_index(mesh, "tip"), 0);
}

TEST(InvalidMesh, AMissingFileAndAFolderAreIoErrors) {
  for (const auto& path : {kFolder / "none.msh", kFolder}) {
    try {
      read_part_mesh(path, 1e-3);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "I001");
    }
  }
}

/// A good mesh with some bytes changed, removed or put elsewhere.
std::string damaged(std::string bytes, std::mt19937& random) {
  const auto place = [&] {
    return std::size_t(random() % bytes.size());
  };
  switch (random() % 5) {
    case 0:
      bytes.resize(place());
      break;
    case 1:
      bytes[place()] = char(random() % 256);
      break;
    case 2:
      bytes.erase(place(), random() % 64);
      break;
    case 3: {  // another digit: indices, counts, types, coordinates
      const std::size_t at = bytes.find_first_of("0123456789", place());
      if (at != std::string::npos) bytes[at] = char('0' + random() % 10);
      break;
    }
    default: {
      const std::string piece = bytes.substr(place(), random() % 64);
      bytes.insert(place(), piece);
      break;
    }
  }
  return bytes;
}

TEST(InvalidMesh, DamagedMeshesAreReadOrRefusedAndNothingElse) {
  std::mt19937 random(20);
  const auto file = std::filesystem::path(::testing::TempDir()) /
                    "clevis_damaged_mesh_test.msh";
  int refused = 0;
  for (const char* name :
       {"box_order_2.msh", "plate_with_bore_22_binary.msh", "sphere.msh",
        "ring_tetrahedra.msh", "ring_flat_tri6.msh", "ring_flat_quad8.msh"}) {
    const std::string good = bytes_of(data(name));
    const bool flat = std::string(name).starts_with("ring_flat");
    for (int i = 0; i < 60; ++i) {
      std::string bytes = damaged(good, random);
      if (i % 3 == 0) bytes = damaged(bytes, random);
      std::ofstream(file, std::ios::binary) << bytes;
      try {
        read_part_mesh(file, 1e-3, flat ? std::optional(8e-3) : std::nullopt);
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  std::filesystem::remove(file);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace clevis::mesh
