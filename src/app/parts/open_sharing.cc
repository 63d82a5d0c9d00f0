#include "app/parts/open_sharing.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "loads/history/balance.h"
#include "loads/parts/part_loads.h"

namespace clevis::app {
namespace {

/// Largest difference of a seat's wrench over the largest wrench [1].
double difference(const loads::LoadHistory& one,
                  const loads::LoadHistory& other, double size) {
  double largest = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < one.instants.size(); ++i) {
    for (std::size_t s = 0; s < one.seats.size(); ++s) {
      const loads::Wrench& a = one.instants[i].wrenches[s];
      const loads::Wrench& b = other.instants[i].wrenches[s];
      largest = std::max({largest, a.force.norm(), a.moment.norm() / size});
      apart = std::max({apart, (a.force - b.force).norm(),
                        (a.moment - b.moment).norm() / size});
    }
  }
  return largest > 0.0 ? apart / largest : 0.0;
}

std::string remedy(const mechanism::OtherSharings& sharings) {
  if (sharings.leaves_forces_out()) {
    return "forces on elastic links elsewhere than at their joints are left "
           "out of the sharing: take links = \"rigid\" and give the joints "
           "compliances that stand for the links too";
  }
  if (!sharings.unknown().empty()) {
    return fmt::format(
        "give {} their compliance, take links = \"elastic\", or remove the "
        "redundant constraints",
        fmt::join(sharings.unknown(), ", "));
  }
  if (!sharings.stiff().empty()) {
    return fmt::format(
        "{} are given less compliance than rigid links have as bars: take "
        "links = \"elastic\", or give compliances that stand for the links too",
        fmt::join(sharings.stiff(), ", "));
  }
  return fmt::format("within twice and half the compliance given to {}",
                     fmt::join(sharings.given(), ", "));
}

}  // namespace

std::optional<assessment::OpenSharing> open_sharing(
    const LoadedScene& loaded, const mechanism::OtherSharings& sharings,
    const LoadedPart& part, const loads::LoadHistory& checked) {
  const double size = loads::part_size(part.groups, part.mass);
  assessment::OpenSharing result{.set = 0,
                                 .checked = checked,
                                 .others = {},
                                 .is_complete = sharings.is_complete(),
                                 .remedy = remedy(sharings)};
  for (std::size_t i = 0; i < sharings.size(); ++i) {
    auto other = loads::part_loads(loaded.scene.mechanism, sharings.motion(i),
                                   loaded.body_of(part.definition.name),
                                   part.definition, part.groups, part.mass);
    if (difference(checked, other, size) <= mechanism::kNegligibleReaction) {
      continue;
    }
    result.others.push_back(std::move(other));
  }
  if (result.others.empty()) return std::nullopt;
  return result;
}

}  // namespace clevis::app
