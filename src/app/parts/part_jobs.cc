#include "app/parts/part_jobs.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/parts/held_part.h"
#include "app/parts/impact_jobs.h"
#include "app/parts/open_sharing.h"
#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "loads/holds/seat_hold.h"
#include "loads/parts/partial_walls.h"
#include "loads/parts/series_loads.h"
#include "loads/seats/part_seats.h"
#include "loads/seats/seat_spans.h"
#include "mesh/quality/mass_properties.h"

namespace clevis::app {
namespace {

using assessment::LoadSet;
using assessment::PartJob;
using mechanism::BodyIndex;
using mechanism::JointDefinition;

/// Index of an entry with the same group (and kind), appended if missing.
template <class Entry, class Same>
std::size_t find_or_append(std::vector<Entry>& entries, const Entry& entry,
                           Same same) {
  const auto found = std::ranges::find_if(entries, [&](const Entry& other) {
    return same(other, entry);
  });
  if (found != entries.end()) {
    return static_cast<std::size_t>(found - entries.begin());
  }
  entries.push_back(entry);
  return entries.size() - 1;
}

loads::SurfaceLoad unloaded(const std::string& group) {
  loads::SurfaceLoad load;
  load.group = group;
  return load;
}

/// Appends the instants of `more`; seats and surfaces become the union.
void merge(loads::LoadHistory& history, const loads::LoadHistory& more) {
  const std::size_t old_seats = history.seats.size();
  std::vector<std::size_t> seat_of;
  for (const auto& seat : more.seats) {
    seat_of.push_back(
        find_or_append(history.seats, seat, [](const auto& a, const auto& b) {
          return a.group == b.group && a.kind == b.kind && a.p_LS == b.p_LS &&
                 !a.slide && !b.slide;
        }));
  }
  std::vector<loads::SurfaceLoad> surfaces;
  const auto collect = [&](const loads::LoadHistory& source) {
    for (const auto& load : source.instants.front().surface_loads) {
      find_or_append(surfaces, unloaded(load.group),
                     [](const auto& a, const auto& b) {
                       return a.group == b.group;
                     });
    }
  };
  collect(history);
  collect(more);
  const std::size_t old_instants = history.instants.size();
  for (const auto& instant : more.instants) {
    loads::InstantLoad moved = instant;
    moved.wrenches.assign(history.seats.size(), {});
    if (!instant.zones.empty()) moved.zones.assign(history.seats.size(), {});
    for (std::size_t s = 0; s < seat_of.size(); ++s) {
      moved.wrenches[seat_of[s]] = instant.wrenches[s];
      if (!instant.zones.empty()) moved.zones[seat_of[s]] = instant.zones[s];
    }
    if (instant.gains) {
      moved.gains = [gains = instant.gains, seat_of] {
        loads::SeatGains found = gains();
        for (std::size_t& seat : found.seats) seat = seat_of[seat];
        return found;
      };
    }
    history.instants.push_back(std::move(moved));
  }
  const auto complete = [&](loads::InstantLoad& instant) {
    std::vector<loads::SurfaceLoad> all = surfaces;
    for (const auto& load : instant.surface_loads) {
      *std::ranges::find(all, load.group, &loads::SurfaceLoad::group) = load;
    }
    instant.surface_loads = std::move(all);
  };
  const auto widen = [&](loads::InstantLoad& instant) {
    instant.wrenches.resize(history.seats.size());
    if (!instant.zones.empty()) instant.zones.resize(history.seats.size());
  };
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    if (i < old_instants) widen(history.instants[i]);
    complete(history.instants[i]);
  }
  for (loads::InstantLoad& instant : history.repeats) {
    widen(instant);
    complete(instant);
  }
  const std::size_t seats = history.seats.size();
  if (seats == old_seats) return;
  for (auto* hold : {&history.hold, &history.lasting_hold}) {
    if (!*hold) continue;
    *hold = [hold = *hold, seats](double time) {
      return loads::on_more_seats(hold(time), seats);
    };
  }
  if (history.hold_at_rest) {
    history.hold_at_rest = [hold = history.hold_at_rest, seats](
                               double time) -> std::optional<loads::SeatHold> {
      auto at_rest = hold(time);
      if (!at_rest) return std::nullopt;
      return loads::on_more_seats(std::move(*at_rest), seats);
    };
  }
}

/// A set for each history, so that its instants stay in the order of time.
void add_series(const LoadedPart& part, PartJob& job) {
  for (const auto& series : part.definition.series) {
    job.load_sets.push_back(
        {loads::series_loads(part.definition, series, part.groups, part.mass),
         series.fixed, series.foundations});
  }
}

void add_cases(const LoadedPart& part, PartJob& job) {
  std::vector<LoadSet>& sets = job.load_sets;
  std::vector<std::vector<std::string>> held_by(sets.size());  // pins of a set
  for (const auto& load_case : part.definition.cases) {
    auto held = held_loads(part, load_case);
    auto pins = load_case.held_by_pin;
    std::ranges::sort(pins);
    std::size_t at = 0;
    while (at < sets.size() &&
           !(sets[at].fixed == load_case.fixed &&
             sets[at].foundations == load_case.foundations &&
             held_by[at] == pins)) {
      ++at;
    }
    if (at < sets.size()) {
      merge(sets[at].history, held.history);
    } else {
      sets.push_back({held.history, load_case.fixed, load_case.foundations});
      held_by.push_back(std::move(pins));
    }
    if (held.others.empty()) continue;
    job.open_sharings.push_back(
        {.set = at,
         .checked = std::move(held.history),
         .others = std::move(held.others),
         .is_complete = false,
         .remedy = "pins of case " + load_case.name +
                   " that give way as much as the part: hold it by fewer"});
  }
}

/// @throws Error L002 of walls that cannot carry their pins.
void note_partial_walls(const LoadedPart& part, PartJob& job) {
  const auto wall_of = [&](const loads::GroupGeometry& group) {
    const auto index = std::ranges::find(part.mesh.groups, group.name,
                                         &mesh::SurfaceGroup::name) -
                       part.mesh.groups.begin();
    auto sample = mesh::sample_surface(part.mesh, static_cast<int>(index));
    return loads::PartialWall{
        std::move(sample.points), std::move(sample.areas),
        mesh::spans_along(part.mesh, static_cast<int>(index),
                          group.cylinder.p_LC, group.cylinder.axis_L)};
  };
  for (LoadSet& set : job.load_sets) {
    loads::note_partial_walls(
        part.groups, wall_of,
        fmt::format("{}: part {}", part.definition.place, part.definition.name),
        set.history);
  }
}

const JointDefinition* joint_of(
    const mechanism::MechanismDefinition& definition, BodyIndex body,
    mechanism::JointType type) {
  const auto found =
      std::ranges::find_if(definition.joints, [&](const JointDefinition& j) {
        return j.type == type && (j.body_a == body || j.body_b == body);
      });
  return found == definition.joints.end() ? nullptr : &*found;
}

/// Buckling length of a body that slides in another: the largest distance
/// between the outer pins of the pair over the motion.
std::optional<double> buckling_length(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion, BodyIndex body) {
  using enum mechanism::JointType;
  const JointDefinition* slide = joint_of(definition, body, kPrismatic);
  if (slide == nullptr) return std::nullopt;
  const BodyIndex other = slide->body_a == body ? slide->body_b : slide->body_a;
  const JointDefinition* pin = joint_of(definition, body, kRevolute);
  const JointDefinition* far_pin = other == mechanism::kGround
                                       ? nullptr
                                       : joint_of(definition, other, kRevolute);
  if (pin == nullptr || far_pin == nullptr) return std::nullopt;
  double longest = 0.0;
  for (const auto& instant : motion.instants) {
    const auto at = [&](const JointDefinition* joint) {
      const auto index =
          static_cast<std::size_t>(joint - definition.joints.data());
      return instant.joints[index].p_WJ;
    };
    longest = std::max(longest, (at(pin) - at(far_pin)).norm());
  }
  return longest;
}

/// Where all parts say that the joints touch them.
loads::SeatSpans seat_spans(const LoadedScene& loaded) {
  loads::SeatSpans spans;
  for (const LoadedPart& part : loaded.parts) {
    const BodyIndex body = loaded.body_of(part.definition.name);
    if (body == mechanism::kGround) continue;
    loads::add_seat_spans(loaded.scene.mechanism, body, part.definition,
                          part.groups, spans);
  }
  return spans;
}

PartJob part_job(const LoadedScene& loaded, const mechanism::Motion& motion,
                 const std::optional<Sharings>& sharings,
                 const LoadedPart& part, double tolerance) {
  PartJob job;
  job.part = part.definition;
  job.mesh = part.mesh;
  job.unrefined = part.unrefined;
  job.mass = part.mass;
  job.groups = part.groups;
  job.tolerance = tolerance;
  job.notes = part.notes;
  const auto& definition = loaded.scene.mechanism;
  const BodyIndex body = loaded.body_of(part.definition.name);
  if (body != mechanism::kGround) {
    // Of other sharings all that is open is marked, however little.
    loads::require_tooth_forces({definition, body, part.definition, part.groups,
                                 loads::part_size(part.groups, part.mass)},
                                motion);
    job.load_sets.push_back(
        {loads::part_loads(definition, motion, body, part.definition,
                           part.groups, part.mass, seat_spans(loaded)),
         {}});
    if (sharings) {
      if (auto open = sharings->of_part(part, job.load_sets.front().history)) {
        job.open_sharings.push_back(std::move(*open));
      }
    }
    job.buckling_length = buckling_length(definition, motion, body);
  }
  add_series(part, job);
  add_cases(part, job);
  note_partial_walls(part, job);
  job.impacts = impact_jobs(definition, motion, part.definition, part.groups);
  if (body != mechanism::kGround) {
    job.impact_loads = impact_loads(definition, motion);
  }
  if (job.load_sets.empty() && job.impacts.empty()) {
    throw Error("S003", part.definition.place,
                fmt::format("nothing loads part \"{}\"", part.definition.name),
                "Give it to a body with `part`, or add a [[part.case]] or a "
                "[[part.history]].");
  }
  return job;
}

}  // namespace

void require_parts(const LoadedScene& loaded,
                   const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const auto& part : loaded.parts) known.push_back(part.definition.name);
  for (const auto& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      throw Error("U001", "--part",
                  fmt::format("the scene has no part \"{}\"", name),
                  fmt::format("Its parts: {}.", fmt::join(known, ", ")));
    }
  }
}

std::vector<PartJob> part_jobs(const LoadedScene& loaded,
                               const mechanism::Motion& motion,
                               const std::vector<std::string>& names,
                               double tolerance) {
  require_parts(loaded, names);
  std::optional<Sharings> sharings;
  if (loaded.scene.has_mechanism) sharings.emplace(loaded, motion);
  std::vector<PartJob> jobs;
  for (const auto& part : loaded.parts) {
    if (!names.empty() &&
        std::ranges::find(names, part.definition.name) == names.end()) {
      continue;
    }
    jobs.push_back(part_job(loaded, motion, sharings, part, tolerance));
  }
  return jobs;
}

}  // namespace clevis::app
