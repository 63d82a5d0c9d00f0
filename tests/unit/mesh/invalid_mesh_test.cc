#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "base/errors.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(CLEVIS_SOURCE_DIR) / "tests/invalid/mesh";

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

TEST(InvalidMesh, EachIsRefusedWithItsCodeWithinASecond) {
  int cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".toml") continue;
    const Expectation expected = expectation(entry.path());
    if (expected.code == "M003") continue;  // the mesh is fine, the scene not
    SCOPED_TRACE(entry.path().filename().string());
    auto file = entry.path();
    file.replace_extension(".msh");
    const auto start = std::chrono::steady_clock::now();
    try {
      read_part_mesh(file, length_unit(entry.path()));
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

}  // namespace
}  // namespace clevis::mesh
