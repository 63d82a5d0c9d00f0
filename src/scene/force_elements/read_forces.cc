#include "scene/force_elements/read_forces.h"

#include <string>

#include <fmt/format.h>

#include "scene/force_elements/read_element.h"

namespace clevis::scene {
namespace {

/// A name for messages and files of entities that need none.
std::string name_or_number(StrictTable& table, std::string_view kind,
                           std::size_t count, NameIndex& index) {
  const auto name = table.find("name");
  const std::string text =
      name ? name->title() : fmt::format("{}_{}", kind, count + 1);
  index.add(text, name ? *name : table["type"]);
  return text;
}

}  // namespace

void read_forces(StrictTable& root, Names& names,
                 mechanism::MechanismDefinition& mechanism) {
  std::size_t count = 0;
  for (StrictTable& table : root.tables("force")) {
    const std::string name =
        name_or_number(table, "force", count++, names.forces);
    mechanism.elements.push_back(
        read_element(name, table, mechanism.joints, names));
  }
}

}  // namespace clevis::scene
