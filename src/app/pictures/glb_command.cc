#include "app/pictures/glb_command.h"

#include <filesystem>
#include <iostream>

#include "app/request/output_folder.h"
#include "report/page/glb_scene.h"
#include "report/text/atomic_file.h"

namespace clevis::app {

ExitCode glb_command(const Options& options) {
  namespace fs = std::filesystem;
  Options asked = options;
  asked.out.clear();
  const fs::path result =
      fs::is_directory(options.scene) ? options.scene : output_folder(asked);
  const fs::path file =
      (options.out.empty() ? result : options.out) / "mechanism.glb";
  report::write_file(file, report::glb_scene(report::read_result_folder(
                               result, report::ResultKind::kCheck)));
  std::cout << file.string() << "\n";
  return ExitCode::kPass;
}

}  // namespace clevis::app
