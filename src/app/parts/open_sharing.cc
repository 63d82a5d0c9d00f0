#include "app/parts/open_sharing.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/parts/link_compliance.h"
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

std::string remedy(const mechanism::OtherSharings& sharings, bool is_elastic) {
  if (sharings.leaves_forces_out()) {
    return "pressure on faces of elastic links is left out of the sharing: "
           "take links = \"rigid\" and give the joints "
           "compliances that stand for the links too";
  }
  if (!sharings.unknown().empty()) {
    return fmt::format(
        "give {} their compliance,{} or remove the redundant constraints",
        fmt::join(sharings.unknown(), ", "),
        is_elastic ? "" : " take links = \"elastic\",");
  }
  return fmt::format("within twice and half the compliance given to {}{}",
                     fmt::join(sharings.given(), ", "),
                     is_elastic
                         ? ""
                         : ", on rigid links and on elastic ones, of which "
                           "links = \"elastic\" takes these alone");
}

bool is_elastic(const LoadedScene& loaded) {
  return loaded.scene.simulation.links == mechanism::LinkStiffness::kElastic;
}

}  // namespace

Sharings::Elastic::Elastic(const LoadedScene& loaded,
                           const mechanism::Motion& motion)
    : definition(with_link_compliances(loaded)), sharings(definition, motion) {}

Sharings::Sharings(const LoadedScene& loaded, const mechanism::Motion& motion)
    : loaded_(loaded), as_given_(loaded.scene.mechanism, motion) {
  // Not given, joints may have any compliance: all that links could add.
  const bool counts =
      !as_given_.given().empty() || !motion.unshared.spun.empty();
  if (counts && !is_elastic(loaded)) elastic_.emplace(loaded, motion);
}

std::optional<assessment::OpenSharing> Sharings::of_part(
    const LoadedPart& part, const loads::LoadHistory& checked) const {
  const double size = loads::part_size(part.groups, part.mass);
  assessment::OpenSharing result{
      .set = 0,
      .checked = checked,
      .others = {},
      .is_complete = true,
      .remedy = remedy(as_given_, is_elastic(loaded_))};
  const auto add = [&](const mechanism::OtherSharings& sharings) {
    result.is_complete &= sharings.is_complete();
    for (std::size_t i = 0; i < sharings.size(); ++i) {
      auto other =
          loads::part_loads(loaded_.scene.mechanism, sharings.motion(i),
                            loaded_.body_of(part.definition.name),
                            part.definition, part.groups, part.mass);
      if (difference(checked, other, size) > mechanism::kNegligibleReaction) {
        result.others.push_back(std::move(other));
      }
    }
  };
  add(as_given_);
  if (elastic_) add(elastic_->sharings);
  if (result.others.empty()) return std::nullopt;
  return result;
}

}  // namespace clevis::app
