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
  constexpr auto kBoth =
      "on rigid links and on elastic ones, of which links = \"elastic\" takes "
      "these alone";
  if (sharings.given().empty()) return kBoth;  // rigid links share nothing
  return fmt::format("within twice and half the compliance given to {}{}{}",
                     fmt::join(sharings.given(), ", "), is_elastic ? "" : ", ",
                     is_elastic ? "" : kBoth);
}

bool is_elastic(const LoadedScene& loaded) {
  return loaded.scene.simulation.links == mechanism::LinkStiffness::kElastic;
}

/// Whether equilibrium leaves reactions open, and joints have a compliance that
/// was given.
bool shares_by_given(const mechanism::MechanismDefinition& definition,
                     const mechanism::Motion& motion) {
  if (std::ranges::none_of(definition.joints, [](const auto& joint) {
        return joint.compliance.has_value();
      })) {
    return false;
  }
  mechanism::Motion some;  // what shares as zero is no longer marked
  const std::size_t count = motion.instants.size();
  for (const std::size_t i : {std::size_t{0}, count / 2, count - 1}) {
    some.instants.push_back(motion.instants[i]);
  }
  some = mechanism::shared_anew(definition, some);
  return std::ranges::any_of(some.instants, [](const auto& instant) {
    return std::ranges::any_of(instant.joints, [](const auto& joint) {
      return !joint.unique;
    });
  });
}

}  // namespace

Sharings::Elastic::Elastic(const LoadedScene& loaded,
                           const mechanism::Motion& rigid)
    : definition(with_link_compliances(loaded, PressedLinks::kRigid)),
      motion(mechanism::shared_anew(definition, rigid)),
      sharings(definition, motion) {}

Sharings::Sharings(const LoadedScene& loaded, const mechanism::Motion& motion)
    : loaded_(loaded), as_given_(loaded.scene.mechanism, motion) {
  if (is_elastic(loaded) || motion.instants.empty()) return;
  if (!motion.unshared.spun.empty() ||
      shares_by_given(loaded.scene.mechanism, motion)) {
    elastic_.emplace(loaded, motion);
  }
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
  const auto add = [&](const mechanism::Motion& motion) {
    auto other = loads::part_loads(loaded_.scene.mechanism, motion,
                                   loaded_.body_of(part.definition.name),
                                   part.definition, part.groups, part.mass);
    if (difference(checked, other, size) > mechanism::kNegligibleReaction) {
      result.others.push_back(std::move(other));
    }
  };
  const auto add_all = [&](const mechanism::OtherSharings& sharings) {
    result.is_complete &= sharings.is_complete();
    for (std::size_t i = 0; i < sharings.size(); ++i) add(sharings.motion(i));
  };
  add_all(as_given_);
  if (elastic_) {
    add(elastic_->motion);
    add_all(elastic_->sharings);
  }
  if (result.others.empty()) return std::nullopt;
  return result;
}

}  // namespace clevis::app
