#include "report/view/view_files.h"

#include "report/text/atomic_file.h"

namespace clevis::report {

std::filesystem::path part_view_file(const std::filesystem::path& folder,
                                     const std::string& part) {
  return folder / kViewFolder / ("part_" + part + ".json");
}

std::filesystem::path motion_view_file(const std::filesystem::path& folder,
                                       ResultKind kind) {
  return folder / kViewFolder /
         (kind == ResultKind::kCheck ? "motion.json" : "simulation.json");
}

void write_part_view(const PartView& view,
                     const std::filesystem::path& folder) {
  write_file(part_view_file(folder, view.definition.name),
             part_view_json(view));
}

void write_motion_view(const MotionView& view,
                       const std::filesystem::path& folder, ResultKind kind) {
  write_file(motion_view_file(folder, kind), motion_view_json(view));
}

}  // namespace clevis::report
