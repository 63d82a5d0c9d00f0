#include "app/geometry_stamp.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "app/temporary_folder.h"
#include "base/errors.h"

namespace clevis::app {
namespace {

const std::string kMesh = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n";

// Published test vectors of FNV-1a, 64 bits.
TEST(GeometryStamp, IsFnv1a) {
  EXPECT_EQ(geometry_stamp(""), "cbf29ce484222325");
  EXPECT_EQ(geometry_stamp("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(geometry_stamp("foobar"), "85944171f73967e8");
}

TEST(GeometryStamp, StandsBehindTheFormatAndIsFoundAgain) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "part.msh";
  const std::string text = stamped(kMesh, "0123456789abcdef");
  std::ofstream(file) << text;
  EXPECT_EQ(stamp_of(file), "0123456789abcdef");
  EXPECT_TRUE(
      text.starts_with("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                       "$Comments\n"));
  EXPECT_TRUE(text.ends_with("\n$EndComments\n$Nodes\n"));
}

TEST(GeometryStamp, IsAbsentFromAForeignMesh) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "part.msh";
  std::ofstream(file) << kMesh;
  EXPECT_EQ(stamp_of(file), std::nullopt);
  EXPECT_EQ(stamp_of(folder.path() / "none.msh"), std::nullopt);
}

TEST(GeometryStamp, MeshOfAnotherVersionIsRefused) {
  const TemporaryFolder folder;
  part::PartDefinition part;
  part.name = "AB";
  part.geometry = folder.path() / "part.geo";
  part.mesh = folder.path() / "part.msh";
  std::ofstream(part.geometry) << "h = 1;";
  std::ofstream(part.mesh) << stamped(kMesh, geometry_stamp("h = 1;"));
  EXPECT_NO_THROW(require_current_mesh(part));
  std::ofstream(part.geometry) << "h = 2;";
  try {
    require_current_mesh(part);
    FAIL() << "a stale mesh passed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "M011");
  }
  part.geometry.clear();
  EXPECT_NO_THROW(require_current_mesh(part));
}

}  // namespace
}  // namespace clevis::app
