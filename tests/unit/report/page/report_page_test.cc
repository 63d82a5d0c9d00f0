#include "report/page/report_page.h"

#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/check/result_files.h"
#include "report/page/glb_scene.h"
#include "report/text/atomic_file.h"
#include "report/text/json_text.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHostile = "</script><script>alert(1)</script>";

/// A triangle of stress 7 MPa.
PartView triangle(const std::string& name) {
  PartView view;
  view.definition.name = name;
  view.definition.material.name = kHostile;
  view.positions = Eigen::MatrixX3d::Identity(3, 3);
  view.places = {0, 1, 2};
  view.triangles = {{0, 1, 2}};
  view.cell_triangles = {1};
  view.frames = {{"t = 0 s", 0.0, 7e6, 1e-3}};
  view.history = view.frames;
  view.stress = pack(Eigen::MatrixXd::Constant(3, 1, 7e6), 0, 1.0, 4);
  view.displacement = pack(Eigen::MatrixXd::Zero(9, 1), 0, 1.0, 4);
  return view;
}

/// The folder of a check with the parts of sample_report().
class ResultFolder : public TestFolder {
 public:
  explicit ResultFolder(double seconds = 1.0) {
    CheckReport report = sample_report();
    report.scene = kHostile;
    report.seconds = {{"total", seconds}};
    for (auto& part : report.parts) {
      part.seconds.total = seconds;
      write_part_view(triangle(part.name), path());
    }
    MotionView motion;
    motion.scene = report.scene;
    write_motion_view(motion, path(), ResultKind::kCheck);
    write_result_files(report, path());
  }

  void change(const fs::path& file, const char* key,
              const nlohmann::ordered_json& value) const {
    auto json = read_json(file);
    json[key] = value;
    write_file(file, json_text(json));
  }
};

std::string refusal(const fs::path& folder) {
  try {
    read_result_folder(folder, result_kind(folder));
  } catch (const Error& error) {
    EXPECT_FALSE(error.remedy().empty());
    return error.code() + " " + error.problem();
  }
  return {};
}

std::size_t count(std::string_view text, std::string_view what) {
  std::size_t n = 0;
  for (auto at = text.find(what); at != text.npos;
       at = text.find(what, at + 1)) {
    ++n;
  }
  return n;
}

TEST(ReportPage, TextsOfAUserEndNoElement) {
  const ResultFolder folder;
  const std::string html =
      report_page(read_result_folder(folder.path(), ResultKind::kCheck));
  // It is told, title included; the parts are compressed.
  EXPECT_EQ(count(html, "alert(1)"), 3U);
  EXPECT_EQ(count(html, "<script>alert"), 0U);
  // result, motion, two parts, the page's own
  EXPECT_EQ(count(html, "</script"), 5U);
}

TEST(ReportPage, AdmitsItsOwnScriptAndStyleOnly) {
  const ResultFolder folder;
  const std::string html =
      report_page(read_result_folder(folder.path(), ResultKind::kCheck));
  EXPECT_EQ(count(html, "default-src 'none'; script-src 'sha256-"), 1U);
  EXPECT_EQ(count(html, "unsafe-"), 0U);
  EXPECT_EQ(count(html, " src="), 0U);
}

TEST(ReportPage, IsTheSameWhateverTimeTheCheckTook) {
  const ResultFolder quick(1.0), slow(2.0);
  EXPECT_EQ(report_page(read_result_folder(quick.path(), ResultKind::kCheck)),
            report_page(read_result_folder(slow.path(), ResultKind::kCheck)));
}

TEST(ReportPage, StandsInTheFolder) {
  const ResultFolder folder;
  EXPECT_EQ(write_report(folder.path(), ResultKind::kCheck),
            folder / "report.html");
  EXPECT_EQ(content_of(folder / "report.html").substr(0, 15),
            "<!DOCTYPE html>");
}

TEST(ResultFolder, ThatIsNotThereIsRefused) {
  const TestFolder folder;
  EXPECT_EQ(refusal(folder / "none"), "I001 there is no such folder");
}

TEST(ResultFolder, OfAnotherProgramIsRefused) {
  const TestFolder folder;
  EXPECT_EQ(refusal(folder.path()).substr(0, 4), "I008");
  write_file(folder / "result.json", "{\"answer\": 42}");
  EXPECT_EQ(refusal(folder.path()),
            "I008 it is none of clevis, or of another version");
}

TEST(ResultFolder, OfAnotherSchemaIsRefused) {
  const ResultFolder folder;
  folder.change(folder / "result.json", "schema", 99);
  EXPECT_EQ(refusal(folder.path()),
            "I008 it is none of clevis, or of another version");
}

TEST(ResultFolder, WithoutViewsIsRefused) {
  const ResultFolder folder;
  const std::string part = sample_report().parts.back().name;
  fs::remove(part_view_file(folder.path(), part));
  EXPECT_EQ(refusal(folder.path()), "I008 the result has no view of the part");
  fs::remove_all(folder / kViewFolder);
  EXPECT_EQ(refusal(folder.path()),
            "I008 the result has no view of its mechanism");
}

TEST(ResultFolder, WithTheViewOfAnotherSceneIsRefused) {
  const ResultFolder folder;
  folder.change(motion_view_file(folder.path(), ResultKind::kCheck), "scene",
                "another");
  EXPECT_EQ(refusal(folder.path()),
            "I008 it is of another scene than the result");
}

TEST(ResultFolder, ThatIsDamagedIsRefused) {
  const ResultFolder folder;
  const std::string text = content_of(folder / "result.json");
  write_file(folder / "result.json", text.substr(0, text.size() / 2));
  EXPECT_EQ(refusal(folder.path()).substr(0, 4), "I003");
}

// Header, JSON chunk, binary chunk, of the lengths that they tell.
TEST(GlbScene, IsAGlbOfItsLength) {
  const ResultFolder folder;
  const std::string glb =
      glb_scene(read_result_folder(folder.path(), ResultKind::kCheck));
  std::uint32_t length{}, json{};
  std::memcpy(&length, glb.data() + 8, sizeof length);
  std::memcpy(&json, glb.data() + 12, sizeof json);
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(length, glb.size());
  const auto parsed = nlohmann::json::parse(glb.substr(20, json));
  EXPECT_EQ(parsed["meshes"].size(), 2U);
  EXPECT_NEAR(
      parsed["materials"][0]["extras"]["von_mises_MPa_of_the_last_colour"]
          .get<double>(),
      7.0, 1e-4);
}

}  // namespace
}  // namespace clevis::report
