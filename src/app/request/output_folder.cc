#include "app/request/output_folder.h"

#include <fstream>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

#include "report/text/atomic_file.h"
#include "report/text/terminal.h"
#include "report/view/view_files.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

void remove_part(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  for (const char* ending : {".vtu", "_linear.vtu", "_history.csv",
                             "_loads.csv", ".pvd", "_buckling.vtu", ".svg"}) {
    fs::remove(folder / (name + ending), ignored);
  }
  fs::remove(report::part_view_file(folder, name), ignored);
  for (const auto& frame :
       fs::directory_iterator(folder / report::kFramesFolder, ignored)) {
    const std::string file = frame.path().filename().string();
    if (file.size() == name.size() + 9 && file.starts_with(name + "_")) {
      fs::remove(frame.path(), ignored);  // NAME_0000.vtu
    }
  }
}

}  // namespace

fs::path output_folder(const Options& options) {
  return options.out.empty() ? results_folder(options.scene) : options.out;
}

fs::path results_folder(const fs::path& scene_file) {
  const fs::path file = fs::weakly_canonical(scene_file);
  const std::string folder = file.parent_path().filename().string();
  const std::string scene = file.stem().string();
  return fs::path("results") /
         (scene == "scene" ? folder : folder + "_" + scene);
}

void remove_previous_run(const fs::path& folder, OldReport report) {
  std::error_code ignored;
  fs::remove(folder / "error.json", ignored);
  if (!fs::is_regular_file(folder / "result.json", ignored)) return;
  std::ifstream file(folder / "result.json");
  const auto result = nlohmann::json::parse(file, nullptr, false);
  if (!result.is_object() || !result.contains("parts")) return;
  for (const auto& part : result["parts"]) {
    if (!part.is_object() || !part.contains("name") ||
        !part["name"].is_string()) {
      continue;
    }
    const auto name = part["name"].get<std::string>();
    if (report::is_file_name(name)) remove_part(folder, name);
  }
  for (const char* name :
       {"mechanism.pvd", "reactions.csv", "parts.csv", "junit.xml",
        "bearings.csv", "mechanism.svg", "result.json"}) {
    fs::remove(folder / name, ignored);
  }
  if (report == OldReport::kRemove) fs::remove(folder / "report.html", ignored);
  fs::remove(report::motion_view_file(folder, report::ResultKind::kCheck),
             ignored);
}

void tell_report(const fs::path& file) {
  std::cerr << "report: " << report::printable(file.string()) << std::endl;
}

}  // namespace clevis::app
