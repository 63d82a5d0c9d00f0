#include "app/parts/impact_jobs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/messages/errors.h"

namespace clevis::app {
namespace {

using mechanism::Impact;
using mechanism::MechanismDefinition;
using mechanism::Motion;

const mechanism::ForceElement& element_of(const MechanismDefinition& definition,
                                          const Impact& impact) {
  return definition.elements[static_cast<std::size_t>(impact.element)];
}

/// Blows of contacts and stops in a driven motion, by its instants: these stand
/// on both sides of each touch and where forces are largest.
std::vector<Impact> presses(const MechanismDefinition& definition,
                            const Motion& motion) {
  std::vector<Impact> found;
  for (std::size_t e = 0; e < definition.elements.size(); ++e) {
    if (!properties(definition.elements[e]).presses) continue;
    bool pressed = false;
    double before = motion.instants.front().t;
    for (const auto& instant : motion.instants) {
      const double effort = instant.elements[e].effort;
      if (effort != 0.0 && !pressed) {
        found.push_back({});
        found.back().element = static_cast<int>(e);
        found.back().end = effort > 0.0 ? 0 : 1;  // a stop's upper end pulls
        found.back().t = before;
      } else if (effort == 0.0 && pressed) {
        found.back().duration = instant.t - found.back().t;
      }
      pressed = effort != 0.0;
      if (pressed && std::abs(effort) > found.back().peak_force) {
        found.back().peak_force = std::abs(effort);
        found.back().peak_at = instant.t;
      }
      before = instant.t;
    }
  }
  return found;
}

const Impact& hardest_of(const MechanismDefinition& definition,
                         const Motion& motion,
                         const part::ImpactDefinition& wanted) {
  const Impact* hardest = nullptr;
  for (const Impact& impact : motion.impacts) {
    if (name_of(element_of(definition, impact)) != wanted.contact) continue;
    if (hardest == nullptr || impact.peak_force > hardest->peak_force) {
      hardest = &impact;
    }
  }
  if (hardest != nullptr && std::isfinite(hardest->mass)) return *hardest;
  const bool is_pressed = std::ranges::any_of(
      presses(definition, motion), [&](const Impact& press) {
        return name_of(element_of(definition, press)) == wanted.contact;
      });
  throw Error(
      "L006", wanted.place,
      fmt::format("impact \"{}\": \"{}\" {}", wanted.name, wanted.contact,
                  hardest == nullptr && !is_pressed
                      ? "is never struck in the motion"
                      : "is struck by what drives hold"),
      "Look at the impacts that clevis simulate lists, or give mass "
      "and speed.");
}

void require_group(const std::string& name,
                   const std::vector<loads::GroupGeometry>& groups,
                   const part::ImpactDefinition& impact) {
  std::vector<std::string> known;
  for (const auto& group : groups) {
    if (group.name == name) return;
    known.push_back(group.name);
  }
  throw Error("M003", impact.place,
              fmt::format("impact \"{}\": the mesh has no group \"{}\"",
                          impact.name, name),
              fmt::format("Its groups: {}.", fmt::join(known, ", ")));
}

}  // namespace

std::vector<assessment::ImpactJob> impact_jobs(
    const MechanismDefinition& definition, const Motion& motion,
    const part::PartDefinition& part,
    const std::vector<loads::GroupGeometry>& groups) {
  std::vector<assessment::ImpactJob> jobs;
  for (const part::ImpactDefinition& given : part.impacts) {
    require_group(given.group, groups, given);
    for (const auto& [group, held] : given.fixed) {
      require_group(group, groups, given);
    }
    assessment::ImpactJob job;
    job.fixed = given.fixed;
    job.source = "given";
    loads::Strike& strike = job.strike;
    strike.name = given.name;
    strike.group = given.group;
    strike.direction = given.direction;
    strike.mass = given.mass;
    strike.speed = given.speed;
    strike.force = given.force;
    strike.contact = {.stiffness = given.stiffness, .exponent = given.exponent};
    strike.duration = given.duration;
    if (!given.contact.empty()) {
      const Impact& impact = hardest_of(definition, motion, given);
      if (mechanism::is_angle(element_of(definition, impact),
                              definition.joints)) {
        throw Error("S010", given.place,
                    fmt::format("contact \"{}\" turns", given.contact),
                    "Name a contact or stop with a force, not a moment.");
      }
      job.source = fmt::format("{} at {:.6g} s", given.contact, impact.t);
      strike.mass = impact.mass;
      strike.speed = impact.approach_speed;
      strike.force = impact.force;
    }
    jobs.push_back(std::move(job));
  }
  return jobs;
}

std::vector<assessment::ImpactLoad> impact_loads(
    const MechanismDefinition& definition, const Motion& motion) {
  const std::vector<Impact> impacts =
      motion.integration ? motion.impacts : presses(definition, motion);
  std::map<std::pair<int, int>, const Impact*> hardest;
  for (const Impact& impact : impacts) {
    const Impact*& known = hardest[{impact.element, impact.end}];
    if (known == nullptr || impact.peak_force > known->peak_force) {
      known = &impact;
    }
  }
  std::vector<assessment::ImpactLoad> loads;
  double largest = 0.0;
  for (const auto& [key, impact] : hardest) {
    largest = std::max(largest, impact->peak_force);
  }
  for (const auto& [key, impact] : hardest) {
    constexpr double kCounts = 0.01;  // what rests on a stop from the start
    if (impact->peak_force < kCounts * largest) continue;
    const auto& element = element_of(definition, *impact);
    std::string name = name_of(element);
    if (mechanism::line_of(element) != nullptr) {
      name += impact->end == 0 ? ", lower" : ", upper";
    }
    const double end = motion.instants.back().t;
    loads.push_back({.name = fmt::format("{} at {:.6g} s", name, impact->t),
                     .duration = impact->duration.value_or(end - impact->t),
                     .rise_time = impact->peak_at - impact->t,
                     .touches = {}});
    constexpr double kAsHard = 0.1;
    for (const Impact& other : impacts) {
      if (other.element == impact->element && other.end == impact->end &&
          other.peak_force >= kAsHard * impact->peak_force) {
        loads.back().touches.push_back(other.t);
      }
    }
  }
  return loads;
}

}  // namespace clevis::app
