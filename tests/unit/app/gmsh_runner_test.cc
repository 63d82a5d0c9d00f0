#include "app/scenes/gmsh_runner.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "app/processes/temporary_folder.h"
#include "base/messages/errors.h"

namespace clevis::app {
namespace {

using std::filesystem::path;

constexpr std::chrono::seconds kLong(120);

constexpr const char* kCube = R"(
Point(1) = {0, 0, 0};
line[] = Extrude {1, 0, 0} { Point{1}; Layers{1}; };
face[] = Extrude {0, 1, 0} { Curve{line[1]}; Layers{1}; Recombine; };
cube[] = Extrude {0, 0, 1} { Surface{face[1]}; Layers{1}; Recombine; };
Physical Volume("body") = {cube[1]};
)";

class GmshRunner : public testing::Test {
 protected:
  path geometry(const std::string& text) const {
    std::ofstream(folder_.path() / "part.geo") << text;
    return folder_.path() / "part.geo";
  }

  /// The refusal of this geometry.
  static Error refusal(const path& file, std::chrono::milliseconds timeout,
                       const std::string& program = "gmsh") {
    try {
      run_gmsh(file, {}, timeout, program);
    } catch (const Error& error) {
      return error;
    }
    return Error("X001", "test", "no refusal", "");
  }

  TemporaryFolder folder_;
};

TEST_F(GmshRunner, ReturnsTheMeshTwiceTheSame) {
  const path file = geometry(kCube);
  const std::string mesh = run_gmsh(file);
  EXPECT_TRUE(mesh.starts_with("$MeshFormat\n4.1 0 8\n"));
  EXPECT_NE(mesh.find("\"body\""), std::string::npos);
  EXPECT_EQ(run_gmsh(file), mesh);
}

// gmsh 4.8.4 leaves out all but the first statement of such a line.
TEST_F(GmshRunner, ReadsALastLineWithoutNewline) {
  const std::string last =
      R"(Physical Surface("x0") = {1};Physical Surface("x1") = {6};Physical )"
      R"(Surface("y0") = {2};)";
  const std::string whole = run_gmsh(geometry(kCube + last + "\n"));
  EXPECT_NE(whole.find("\"y0\""), std::string::npos);
  EXPECT_EQ(run_gmsh(geometry(kCube + last)), whole);
}

// Its includes stand beside it, not beside the file that ends the line for it.
TEST_F(GmshRunner, ReadsIncludesBesideALastLineWithoutNewline) {
  std::ofstream(folder_.path() / "cube.geo") << kCube;
  const std::string include = "Include \"cube.geo\";\n";
  const std::string last = R"(a = 1;Physical Surface("x0") = {1};)";
  const std::string whole = run_gmsh(geometry(include + last + "\n"));
  EXPECT_NE(whole.find("\"x0\""), std::string::npos);
  EXPECT_EQ(run_gmsh(geometry(include + last)), whole);
}

TEST_F(GmshRunner, RefusesALastLineWithoutNewlineThatNamesAFile) {
  std::ofstream(folder_.path() / "cube.geo") << kCube;
  const path file = geometry("a = 1;\nb = 2;Include \"cube.geo\";");
  const Error error = refusal(file, kLong);
  EXPECT_EQ(error.code(), "M010");
  EXPECT_EQ(error.place(), file.string() + ":2");
  EXPECT_NE(error.problem().find("newline"), std::string::npos)
      << error.problem();
}

TEST_F(GmshRunner, QuotesTheFirstErrorOfGmsh) {
  const Error error = refusal(geometry("Line(1) = {1, 2};\n"), kLong);
  EXPECT_EQ(error.code(), "M010");
  EXPECT_NE(error.problem().find("Unknown control point 1"), std::string::npos)
      << error.problem();
}

// A misspelt name is an error of gmsh, though it goes on and writes a mesh.
TEST_F(GmshRunner, RefusesWhatGmshOnlyGrumblesAbout) {
  const Error error =
      refusal(geometry(std::string(kCube) + "a = misspelt;\n"), kLong);
  EXPECT_EQ(error.code(), "M010") << error.problem();
  EXPECT_NE(error.problem().find("misspelt"), std::string::npos);
}

TEST_F(GmshRunner, RefusesAGeometryThatWritesNoMesh) {
  const Error error = refusal(geometry("Exit;\n"), kLong);
  EXPECT_EQ(error.code(), "M010") << error.problem();
}

TEST_F(GmshRunner, StartsNoProgramOfAGeometry) {
  const path ran = folder_.path() / "ran";
  for (const std::string call : {"SystemCall", "NonBlockingSystemCall"}) {
    const Error error = refusal(
        geometry(call + " \"touch " + ran.string() + "\";\n" + kCube), kLong);
    EXPECT_EQ(error.code(), "M010");
    EXPECT_NE(error.problem().find("SystemCall"), std::string::npos)
        << error.problem();
    EXPECT_FALSE(std::filesystem::exists(ran)) << call;
  }
}

TEST_F(GmshRunner, EndsWhatTakesTooLong) {
  const auto start = std::chrono::steady_clock::now();
  const Error error =
      refusal(geometry("Sleep 60;\n"), std::chrono::milliseconds(500));
  EXPECT_EQ(error.code(), "M010");
  EXPECT_NE(error.problem().find("0.5 s"), std::string::npos)
      << error.problem();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(GmshRunner, SaysThatGmshIsNotInstalled) {
  const Error error = refusal(geometry(kCube), kLong, "no-such-mesher");
  EXPECT_EQ(error.code(), "M010");
  EXPECT_NE(error.remedy().find("Install"), std::string::npos);
}

// Whose shell may start what it wants, and is ended with it.
TEST_F(GmshRunner, RunsAScriptThatStandsForGmsh) {
  const path script = folder_.path() / "my-gmsh";
  std::ofstream(script) << "#!/bin/sh\ngmsh \"$@\"\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  EXPECT_TRUE(run_gmsh(geometry(kCube), {}, kLong, script.string())
                  .starts_with("$MeshFormat"));
  std::ofstream(script) << "#!/bin/sh\nsleep 60\n";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(
      refusal(geometry(kCube), std::chrono::milliseconds(300), script.string())
          .code(),
      "M010");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

// gmsh that cannot be loaded, or that a library ends, has no line "Error".
TEST_F(GmshRunner, QuotesWordsThatAreNoError) {
  const path script = folder_.path() / "my-gmsh";
  const auto said = [&](const std::string& body) {
    std::ofstream(script) << "#!/bin/sh\n" << body;
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    return refusal(geometry(kCube), kLong, script.string()).problem();
  };
  EXPECT_EQ(said("echo 'Info    : Running'\n"
                 "echo 'libgmsh.so.4.8: no such file' >&2\nexit 127\n"),
            "gmsh ended with exit code 127 and says: libgmsh.so.4.8: no such "
            "file");
  EXPECT_EQ(said("echo 'Info    : Running'\nkill -ABRT $$\n"),
            "gmsh was ended by signal 6 (Aborted) without a message");
}

TEST_F(GmshRunner, RefusesAMissingFile) {
  EXPECT_EQ(refusal(folder_.path() / "none.geo", kLong).code(), "I001");
}

}  // namespace
}  // namespace clevis::app
