#include "app/scenes/geometry_stamp.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "app/processes/temporary_folder.h"
#include "app/scenes/geometry_files.h"
#include "base/messages/errors.h"

namespace clevis::app {
namespace {

const std::string kMesh = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n";

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
  std::ofstream(part.mesh) << stamped(kMesh, geometry_stamp(part));
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

TEST(GeometryStamp, CoversWhatTheGeometryMerges) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const char* text) {
    std::filesystem::create_directories(folder.path() / "cad");
    std::ofstream(folder.path() / name) << text;
  };
  part::PartDefinition part;
  part.name = "bracket";
  part.geometry = folder.path() / "part.geo";
  part.mesh = folder.path() / "part.msh";
  write("part.geo",
        "Include \"cad/sizes.geo\";\nv() = ShapeFromFile( \"x.step\" );\n"
        "Merge \"none.brep\"; Merged = 1;");
  write("cad/sizes.geo", "h = 1; Merge\n\"boss.step\";");
  write("cad/boss.step", "boss");
  write("x.step", "plate");
  const std::string stamp = geometry_stamp(part);
  std::ofstream(part.mesh) << stamped(kMesh, stamp);
  EXPECT_NO_THROW(require_current_mesh(part));
  for (const char* name : {"cad/sizes.geo", "cad/boss.step", "x.step"}) {
    const std::string before = geometry_content(folder.path() / name);
    write(name, "another");
    EXPECT_THROW(require_current_mesh(part), Error) << name;
    std::ofstream(folder.path() / name) << before.substr(0, before.find('\0'));
    EXPECT_NO_THROW(require_current_mesh(part)) << name;
  }
  write("none.brep", "was not there");
  EXPECT_THROW(require_current_mesh(part), Error);
}

TEST(GeometryStamp, OfAFileThatReadsNoOtherIsThatOfItsBytes) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "part.geo";
  std::ofstream(file) << "Include \"part.geo\";";
  EXPECT_EQ(geometry_content(file), "Include \"part.geo\";");
}

}  // namespace
}  // namespace clevis::app
