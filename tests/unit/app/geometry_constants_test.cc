#include "app/scenes/geometry_constants.h"

#include <fstream>

#include <gtest/gtest.h>

#include "app/processes/temporary_folder.h"
#include "base/messages/errors.h"

namespace clevis::app {
namespace {

using Names = std::set<std::string, std::less<>>;

TEST(GeometryConstants, AreThoseOfDefineConstantInWhateverLayout) {
  const auto found = geometry_constants(
      "DefineConstant[ a = 3, // b = 4,\n c = {5, Name \"x, y = 1\"},\n"
      " d = Sqrt(a, 2) ];\n/* DefineConstant[ e = 1 ]; */\n"
      "DefineConstant( f = 1 );\nprint = \"DefineConstant[ g = 1 ]\";\n");
  EXPECT_EQ(found.constants, (Names{"a", "c", "d", "f"}));
  EXPECT_EQ(found.assigned, (Names{"print"}));
}

TEST(GeometryConstants, AssignmentsAreToldFromComparisonsAndIndices) {
  const auto found = geometry_constants(
      "If (a == 1)\n b = 2; c += 1; EndIf\nd[] = {1};\nPoint(p) = {0, 0, 0};");
  EXPECT_EQ(found.assigned, (Names{"b", "c"}));
}

TEST(GeometryConstants, ParametersThatTheFileWouldNotTakeAreRefused) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "part.geo";
  std::ofstream(folder.path() / "sizes.geo") << "DefineConstant[ width = 3 ];";
  std::ofstream(file) << "Include \"sizes.geo\";\n"
                         "DefineConstant[ radius = 3 ];\nthickness = 5;\n";
  const auto problem = [&](const char* name) {
    try {
      require_constants(file, {{name, 1.0, "--set 1"}});
    } catch (const Error& error) {
      return error.code() + " " + error.place() + ": " + error.problem() + " " +
             error.remedy();
    }
    return std::string("accepted");
  };
  EXPECT_EQ(problem("radius"), "accepted");
  EXPECT_EQ(problem("width"), "accepted");
  EXPECT_NE(problem("radios").find("S007 --set 1"), std::string::npos);
  EXPECT_NE(problem("radios").find("Did you mean \"radius\"?"),
            std::string::npos);
  EXPECT_NE(problem("thickness").find("part.geo assigns thickness itself"),
            std::string::npos);
}

}  // namespace
}  // namespace clevis::app
