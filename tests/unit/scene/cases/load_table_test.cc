#include "scene/cases/load_table.h"

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/messages/errors.h"

namespace clevis::scene {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

class LoadTableFile : public ::testing::Test {
 protected:
  fs::path file_ = fs::temp_directory_path() /
                   ("load_table_" + std::to_string(getpid()) + ".csv");
  void TearDown() override { fs::remove(file_); }

  LoadTable read(const std::string& text) const {
    std::ofstream(file_) << text;
    return LoadTable(file_);
  }
  /// "CODE:line:column" of what is refused.
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const Error& error) {
      return error.code() + error.place().substr(file_.string().size());
    }
    return "";
  }
};

TEST_F(LoadTableFile, UnitsOfTheHeaderScaleTheColumns) {
  const LoadTable table = read(
      "time [ms],A.force_y [kN],A.moment_z [N mm],top.pressure [MPa],"
      "angular_velocity_z [rpm]\n1,2,3,4,60\n1.5,+5e-1, -6 ,7,30\n");
  ASSERT_EQ(table.rows(), 2u);
  ASSERT_EQ(table.loads().size(), 2u);
  const LoadColumns& A = table.loads().front();
  EXPECT_EQ(A.name, "A");
  EXPECT_TRUE(A.has_wrench());
  EXPECT_FALSE(table.loads().back().has_wrench());
  EXPECT_DOUBLE_EQ(table.time(1), 1.5e-3);
  EXPECT_EQ(table.vector(0, A.force), Vector3d(0.0, 2e3, 0.0));
  EXPECT_EQ(table.vector(1, A.force), Vector3d(0.0, 500.0, 0.0));
  EXPECT_DOUBLE_EQ(table.vector(1, A.moment).z(), -6e-3);
  EXPECT_DOUBLE_EQ(table.value(0, table.loads().back().pressure), 4e6);
  EXPECT_DOUBLE_EQ(table.angular_velocity(0).z(), 2.0 * std::numbers::pi);
  EXPECT_FALSE(table.has_acceleration());
  EXPECT_FALSE(table.has_orientation());
}

TEST_F(LoadTableFile, NamesMayHoldDotsAndSpaces) {
  const LoadTable table =
      read("time [s],link 1.pin.force_x [N],\"a,b.force_x [N]\"\n0,1,2\n");
  EXPECT_EQ(table.loads()[0].name, "link 1.pin");
  EXPECT_EQ(table.loads()[1].name, "a,b");
}

TEST_F(LoadTableFile, OrientationTurnsThePartsFrameIntoTheWorlds) {
  const LoadTable table = read(
      "time [s],A.force_x [N],orientation_w,orientation_x,orientation_y,"
      "orientation_z\n0,1,0.6,0,0,0.8\n");
  const Vector3d turned = table.orientation(0) * Vector3d::UnitX();
  EXPECT_NEAR(turned.x(), 0.36 - 0.64, 1e-15);
  EXPECT_NEAR(turned.y(), 2.0 * 0.6 * 0.8, 1e-15);
}

TEST_F(LoadTableFile, TellsWhichOtherSeparatorStands) {
  EXPECT_EQ(refusal("time [s];A.force_x [N]\n0;1,5\n"), "S012:1:1");
  EXPECT_EQ(refusal("sep=;\ntime [s];A.force_x [N]\n0;1\n"), "S012:1:1");
  EXPECT_EQ(refusal("time [s]\tA.force_x [N]\n0\t1\n"), "S012:1:1");
  try {
    read("time [s];A.force_x [N]\n0;1,5\n");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.problem(),
              "semicolons separate the columns, commas are wanted");
  }
}

TEST_F(LoadTableFile, RefusesWhatItDoesNotUnderstand) {
  EXPECT_EQ(refusal(""), "S012:1:1");
  EXPECT_EQ(refusal("time [s]\n"), "S012:1:1");
  EXPECT_EQ(refusal("A.force_x [N]\n1\n"), "S003:1:1");
  EXPECT_EQ(refusal("time [s],force_x [N]\n0,1\n"), "S002:1:10");
  EXPECT_EQ(refusal("time [s],A.force_w [N]\n0,1\n"), "S002:1:10");
  EXPECT_EQ(refusal("time [s],.force_x [N]\n0,1\n"), "S002:1:10");
  EXPECT_EQ(refusal("time,A.force_x [N]\n0,1\n"), "S004:1:1");
  EXPECT_EQ(refusal("time [s],A.force_x [kg]\n0,1\n"), "S004:1:10");
  EXPECT_EQ(refusal("time [s],A.force_x [N],A.force_x [kN]\n0,1,1\n"),
            "S012:1:24");
  EXPECT_EQ(refusal("time [s],A.force_x [N]\n0,\n"), "S005:2:3");
  EXPECT_EQ(refusal("time [s],A.force_x [N]\n0,1 N\n"), "S005:2:3");
  EXPECT_EQ(refusal("time [s],A.force_x [N]\n0,inf\n"), "S005:2:3");
  EXPECT_EQ(refusal("time [s],A.force_x [N]\n0,1\n0,2\n-1,1\n"), "S006:4:1");
  EXPECT_EQ(refusal("time [s],orientation_w\n0,1\n"), "S003:1:1");
  EXPECT_EQ(refusal("time [s],orientation_w,orientation_x,orientation_y,"
                    "orientation_z\n0,1,0,0,0\n1,-1,0,0,1e-4\n2,0,0,0,1\n"),
            "S003:4:1");
  const auto about_z = [this](const std::string& component) {
    return refusal(
        "time [s],orientation_w,orientation_x,orientation_y,"
        "orientation_z,angular_velocity_" +
        component + " [rad/s]\n0,1,0,0,0,0\n1,0,0,0,1,0\n");
  };
  EXPECT_EQ(about_z("x"), "S003:3:1");
  EXPECT_EQ(about_z("z"), "");
  EXPECT_EQ(refusal("time [s],orientation_w,orientation_x,orientation_y,"
                    "orientation_z\n0,1,0,0,0\n1,1,0,0,1\n"),
            "S006:3:1");
}

}  // namespace
}  // namespace clevis::scene
