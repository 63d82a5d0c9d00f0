#include "app/joined/joined_verdicts.h"

#include <cstddef>

#include "assessment/joined/joined_parts.h"
#include "mechanism/structure/joined_bodies.h"
#include "report/page/result_folder.h"
#include "report/picture/part_picture.h"
#include "report/text/atomic_file.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

/// Names of the parts that groups of bodies carry.
std::vector<std::vector<std::string>> parts_on(
    const std::vector<std::vector<mechanism::BodyIndex>>& groups,
    const mechanism::MechanismDefinition& mechanism) {
  std::vector<std::vector<std::string>> parts;
  for (const auto& bodies : groups) {
    auto& names = parts.emplace_back();
    for (const mechanism::BodyIndex body : bodies) {
      const auto& part = mechanism.bodies[static_cast<std::size_t>(body)].part;
      if (!part.empty()) names.push_back(part);
    }
  }
  return parts;
}

}  // namespace

std::vector<std::string> doubt_joined_parts(
    const mechanism::MechanismDefinition& mechanism,
    const std::vector<assessment::PartJob>& jobs,
    std::vector<assessment::PartResult>& results) {
  const auto joined = mechanism::joined_bodies(mechanism);
  return assessment::doubt_by_joined(
      jobs,
      {parts_on(joined.moving, mechanism), parts_on(joined.stiffly, mechanism),
       parts_on(joined.elastically, mechanism)},
      results);
}

void draw_anew(const std::vector<std::string>& parts, const fs::path& folder) {
  if (parts.empty()) return;
  const auto page =
      report::read_result_folder(folder, report::ResultKind::kCheck);
  for (const std::string& part : parts) {
    const fs::path picture = folder / (part + ".svg");
    if (!fs::exists(picture)) continue;
    report::write_file(picture, report::stored_part_picture(page, part));
  }
}

}  // namespace clevis::app
