#include "app/joined/joined_verdicts.h"

#include <algorithm>
#include <cstddef>
#include <variant>

#include "assessment/joined/joined_parts.h"
#include "mechanism/force_elements/force_element.h"
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

/// Whether an element's force grows with what moves it.
bool gives_way(const mechanism::ForceElement& element) {
  const auto* line = std::get_if<mechanism::LineElement>(&element);
  if (line == nullptr) {
    return !std::holds_alternative<mechanism::ConstantForce>(element);
  }
  const mechanism::LineLaw& law = line->law;
  return std::holds_alternative<mechanism::SpringLaw>(law) ||
         std::holds_alternative<mechanism::StopLaw>(law) ||
         std::holds_alternative<mechanism::GasCylinderLaw>(law) ||
         std::holds_alternative<mechanism::ServoLaw>(law);
}

/// What holds bodies that hang together with a part's and gives way.
std::vector<assessment::YieldingElements> elements_on_parts(
    const mechanism::MechanismDefinition& mechanism,
    const mechanism::JoinedBodies& joined) {
  std::vector<assessment::YieldingElements> found;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    if (mechanism.bodies[b].part.empty()) continue;
    std::vector<mechanism::BodyIndex> together = {
        static_cast<mechanism::BodyIndex>(b)};
    for (const auto& group : joined.moving) {
      if (std::ranges::find(group, together[0]) != group.end()) {
        together = group;
        break;
      }
    }
    auto& of_part = found.emplace_back();
    of_part.part = mechanism.bodies[b].part;
    for (const mechanism::ForceElement& element : mechanism.elements) {
      if (gives_way(element) &&
          std::ranges::any_of(together, [&](mechanism::BodyIndex body) {
            return acts_on(element, mechanism.joints, body);
          })) {
        of_part.names.push_back(name_of(element));
      }
    }
  }
  return found;
}

}  // namespace

std::vector<std::string> doubt_joined_parts(
    const mechanism::MechanismDefinition& mechanism,
    const mechanism::Motion& motion,
    const std::vector<assessment::PartJob>& jobs,
    std::vector<assessment::PartResult>& results) {
  const auto joined = mechanism::joined_bodies(mechanism);
  if (motion.integration) {  // else drives hold, whatever elements do
    assessment::note_elements(elements_on_parts(mechanism, joined), results);
  }
  return assessment::doubt_by_joined(
      jobs,
      {parts_on(joined.moving, mechanism), parts_on(joined.stiffly, mechanism)},
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
