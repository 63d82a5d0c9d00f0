#include "scene/parts/part_names.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "part/supports.h"

namespace clevis::scene {
namespace {

/// Of how many supports `export` and `modes` write a file each: NAME, NAME_2 …
int supports_of(const part::PartDefinition& part,
                const mechanism::MechanismDefinition& mechanism) {
  std::set<std::pair<part::Supports, std::vector<std::string>>> all;
  if (std::ranges::find(mechanism.bodies, part.name,
                        &mechanism::BodyDefinition::part) !=
      mechanism.bodies.end()) {
    all.emplace();
  }
  for (const auto& load_case : part.cases) {
    auto pins = load_case.held_by_pin;
    std::ranges::sort(pins);
    all.insert({load_case.fixed, std::move(pins)});
  }
  for (const auto& series : part.series) all.insert({series.fixed, {}});
  for (const auto& impact : part.impacts) all.insert({impact.fixed, {}});
  return static_cast<int>(all.size());
}

/// N of a file NAME_N of another part's supports; 0: none.
int number_behind(const std::string& name, const std::string& start) {
  if (!name.starts_with(start + "_")) return 0;
  const char* begin = name.data() + start.size() + 1;
  const char* end = name.data() + name.size();
  int number = 0;
  const auto [rest, failure] = std::from_chars(begin, end, number);
  const bool is_plain = failure == std::errc() && rest == end && *begin != '0';
  return is_plain ? number : 0;
}

}  // namespace

void require_own_files(std::vector<StrictTable>& tables,
                       const mechanism::MechanismDefinition& mechanism,
                       const std::vector<part::PartDefinition>& parts) {
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::string& name = parts[p].name;
    const auto refuse = [&](const std::string& what) {
      return tables[p]["name"].refusal(
          "S008", fmt::format("= \"{}\" would write {}", name, what),
          "Call the part something else.");
    };
    if (name == "mechanism") throw refuse("over the assembly's mechanism.pvd");
    for (const auto& other : parts) {
      if (name == other.name + "_linear" || name == other.name + "_buckling") {
        throw refuse(
            fmt::format("over {}.vtu of part \"{}\"", name, other.name));
      }
      const int number = number_behind(name, other.name);
      if (number >= 2 && number <= supports_of(other, mechanism)) {
        throw refuse(
            fmt::format("over {}.inp and {}_mode_1.vtu of part \"{}\", which "
                        "has {} sets of "
                        "supports",
                        name, name, other.name, supports_of(other, mechanism)));
      }
    }
  }
}

}  // namespace clevis::scene
