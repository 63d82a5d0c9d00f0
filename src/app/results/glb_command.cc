#include "app/results/glb_command.h"

#include <filesystem>
#include <iostream>

#include "app/request/output_folder.h"
#include "base/messages/errors.h"
#include "report/page/glb_scene.h"
#include "report/text/atomic_file.h"

namespace clevis::app {

ExitCode glb_command(const Options& options) {
  namespace fs = std::filesystem;
  Options asked = options;
  asked.out.clear();
  if (!fs::exists(options.scene)) {
    throw Error("I001", options.scene.string(),
                "there is no such scene, nor a folder of that name",
                "Give a scene that has been checked, or the folder of its "
                "result.");
  }
  const fs::path result =
      fs::is_directory(options.scene) ? options.scene : output_folder(asked);
  if (!fs::exists(result)) {
    throw Error("I008", options.scene.string(),
                "no result of it stands in " + result.string(),
                "Run `clevis check` first, or give the folder of its result.");
  }
  const fs::path file =
      (options.out.empty() ? result : options.out) / "mechanism.glb";
  report::write_file(file, report::glb_scene(report::read_result_folder(
                               result, report::ResultKind::kCheck)));
  std::cout << file.string() << "\n";
  return ExitCode::kPass;
}

}  // namespace clevis::app
