#include "assessment/buckling/part_holds.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "loads/history/motion_instants.h"
#include "loads/holds/holding_groups.h"
#include "loads/holds/slide_places.h"

namespace clevis::assessment {
namespace {

using elasticity::HoldingSeats;
using Instants = std::vector<Eigen::Index>;

/// Largest force on a seat [N].
double largest_force(const loads::InstantLoad& instant) {
  double most = 0.0;
  for (const auto& wrench : instant.wrenches) {
    most = std::max(most, wrench.force.norm());
  }
  return most;
}

bool has_slide(const HoldingSeats& hold,
               const std::vector<loads::Seat>& seats) {
  for (std::size_t s = 0; s < seats.size(); ++s) {
    if (seats[s].slide &&
        std::ranges::find(hold.groups, loads::holder_of(seats, s)) !=
            hold.groups.end()) {
      return true;
    }
  }
  return false;
}

/// Instants of a motion by places of its slides, both ends by themselves as
/// well.
std::vector<Instants> by_place(const loads::LoadHistory& history) {
  constexpr int kPlaces = 16, kEnds = 256;  // bins: an end is the last of many
  std::vector<Instants> found;
  for (const int bins : {kPlaces, kEnds}) {
    const auto places = loads::slide_places(history, bins);
    std::map<int, Instants> at_place;
    for (std::size_t i = 0; i < places.of.size(); ++i) {
      if (places.of[i] == loads::SlidePlaces::kUnknown) continue;
      at_place[places.of[i]].push_back(static_cast<Eigen::Index>(i));
    }
    for (auto& [place, at] : at_place) {
      const bool is_end = place == 0 || place == places.bins - 1;
      if (bins == kPlaces || is_end) found.push_back(std::move(at));
    }
  }
  return found;
}

/// Instants of a motion in sixteen parts, both ends by themselves.
std::vector<Instants> by_time(std::size_t motion) {
  constexpr std::size_t kParts = 16;
  std::vector<Instants> found(kParts + 2);
  for (std::size_t i = 0; i < motion; ++i) {
    const bool is_end = i == 0 || i + 1 == motion;
    const std::size_t part =
        is_end ? (i == 0 ? 0 : kParts + 1) : 1 + i * kParts / motion;
    found[part].push_back(static_cast<Eigen::Index>(i));
  }
  std::erase_if(found, [](const Instants& at) {
    return at.empty();
  });
  return found;
}

/// The instant of some that has the largest forces.
const loads::InstantLoad& hardest_of(const loads::LoadHistory& history,
                                     const Instants& at) {
  const auto instant = [&](Eigen::Index i) -> const loads::InstantLoad& {
    return history.instants[static_cast<std::size_t>(i)];
  };
  return instant(*std::ranges::max_element(at, {}, [&](Eigen::Index i) {
    return largest_force(instant(i));
  }));
}

/// How groups hold at a time.
/// @param with_all  whether all that is held counts, where it is redundant.
HoldingSeats hold_of(const loads::LoadHistory& history,
                     const loads::HoldingGroups& groups, double time,
                     bool with_all) {
  HoldingSeats hold;
  if (with_all && history.hold) {
    hold.held = loads::held_groups(history, time);
    hold.with_all = loads::is_redundant(hold.held);
    hold.groups = groups;
    if (hold.with_all) return hold;
  }
  auto found = loads::hold_at(history, groups, time);
  hold.groups = std::move(found.groups);
  hold.held = std::move(found.held);
  return hold;
}

/// Where both of two groups hold the roll about the line between them, either
/// may have the play: both ways.
std::vector<HoldingSeats> holds_of(const loads::LoadHistory& history,
                                   const loads::HoldingGroups& groups,
                                   double time, bool with_all) {
  std::vector<HoldingSeats> found = {hold_of(history, groups, time, with_all)};
  if (groups.size() != 2 || !found.front().held.empty()) return found;
  HoldingSeats other =
      hold_of(history, {groups.back(), groups.front()}, time, with_all);
  if (other.groups != found.front().groups) found.push_back(std::move(other));
  return found;
}

bool are_alike(const HoldingSeats& one, const HoldingSeats& other) {
  return !one.touched && !other.touched && one.groups == other.groups &&
         one.with_all == other.with_all &&
         loads::are_alike(one.held, other.held);
}

/// With the instants of holds that are alike.
void add(HoldingSeats hold, std::vector<HoldingSeats>& holds) {
  const auto known =
      std::ranges::find_if(holds, [&](const HoldingSeats& other) {
        return are_alike(hold, other);
      });
  if (known == holds.end()) {
    holds.push_back(std::move(hold));
    return;
  }
  known->instants.insert(known->instants.end(), hold.instants.begin(),
                         hold.instants.end());
  std::ranges::sort(known->instants);
  const auto same = std::ranges::unique(known->instants);
  known->instants.erase(same.begin(), same.end());
}

}  // namespace

std::vector<HoldingSeats> part_holds(const LoadSet& set,
                                     const loads::LoadHistory& history,
                                     bool with_all) {
  std::vector<std::vector<HoldingSeats>> whole;
  for (const auto& groups : loads::holding_groups(history)) {
    whole.push_back(holds_of(history, groups, history.hold_time, with_all));
  }
  std::vector<HoldingSeats> holds;
  if (!set.fixed.empty() || !set.foundations.empty()) {
    for (const auto& ways : whole) holds.push_back(ways.front());
    return holds;
  }
  // All hold, whatever the groups.
  if (whole.front().front().with_all) whole.resize(1);
  const std::size_t motion = loads::motion_length(history);
  const auto places = by_place(history);
  const auto times = motion > 1 ? by_time(motion) : std::vector<Instants>{};
  for (const auto& ways : whole) {
    const HoldingSeats& one = ways.front();
    const bool slides = has_slide(one, history.seats) && !places.empty();
    std::vector<bool> is_known(history.instants.size(), false);
    for (const Instants& at : slides         ? places
                              : history.hold ? times
                                             : std::vector<Instants>{}) {
      const loads::InstantLoad& hardest = hardest_of(history, at);
      for (HoldingSeats& hold :
           holds_of(history, one.groups, hardest.time, with_all)) {
        if (slides) hold.touched = {history.seats, hardest.zones};
        hold.instants = at;
        add(std::move(hold), holds);
      }
      for (const Eigen::Index i : at) {
        is_known[static_cast<std::size_t>(i)] = true;
      }
    }
    Instants rest;
    for (std::size_t i = 0; i < is_known.size(); ++i) {
      if (!is_known[i]) rest.push_back(static_cast<Eigen::Index>(i));
    }
    if (rest.empty()) continue;
    if (rest.size() == is_known.size()) rest.clear();
    for (HoldingSeats hold : ways) {
      hold.instants = rest;
      add(std::move(hold), holds);
    }
  }
  for (HoldingSeats& hold : holds) {
    if (hold.instants.size() == history.instants.size()) hold.instants.clear();
  }
  return holds;
}

bool is_held_redundantly(const LoadSet& set) {
  const loads::LoadHistory& history = set.history;
  return set.fixed.empty() && set.foundations.empty() && history.hold &&
         loads::is_redundant(loads::held_groups(history, history.hold_time));
}

}  // namespace clevis::assessment
