#include "mechanism/reactions/reaction_friction.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/forces/given_efforts.h"

namespace clevis::mechanism {
namespace {

constexpr double kSettled = 1e-13;  // of the largest effort

/// Friction "name" of joint "name".
std::string with_its_joint(const MechanismDefinition& definition,
                           const ForceElement& element) {
  const auto joint = static_cast<std::size_t>(line_of(element)->joint);
  return fmt::format("friction {} of joint {}", name_of(element),
                     definition.joints[joint].name);
}

}  // namespace

double followed_force(const ActingElement& element, double q,
                      const JointReaction& reaction) {
  return pressing_force(end_forces(element.guide(), q, reaction.components()));
}

Equilibrium::Solution balance_with_friction(
    const MechanismDefinition& definition, const ForceModel& forces,
    ForceState& acting, std::size_t slots,
    const std::function<Equilibrium::Solution(std::span<const Twist>)>&
        balance) {
  constexpr int kMost = 300;
  std::vector<SpatialForce> applied(slots);
  forces.add_to(acting, applied);
  Equilibrium::Solution solution = balance(applied);
  std::size_t fastest = 0;
  for (int i = 0; i < kMost; ++i) {
    double change = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const int joint = forces.element(k).followed_joint();
      if (joint < 0) continue;
      const auto& reaction = solution.joints[static_cast<std::size_t>(joint)];
      ElementResponse& element = acting.elements[k];
      const double before = element.load;
      const double load =
          followed_force(forces.element(k), element.q, reaction);
      give_load(forces.element(k), load, element);
      const double by = std::abs(load - before);
      if (!(by <= change)) fastest = k;
      change = std::max(change, by);
      largest = std::max(largest, load);
    }
    if (!std::isfinite(largest)) break;
    if (change <= kSettled * largest) return solution;
    std::ranges::fill(applied, Twist{});
    forces.add_to(acting, applied);
    solution = balance(applied);
  }
  const ForceElement& element = definition.elements[fastest];
  throw Error("K011", place_of(element),
              with_its_joint(definition, element) +
                  ", which follows the reaction, grows with it without bound",
              "Reduce the friction coefficient or the pin radius, or drive "
              "another joint.");
}

namespace {

bool some_friction_rests(const ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).is_dry() &&
        std::abs(forces.element(k).modes[0]) != 1) {
      return true;
    }
  }
  return false;
}

/// Whether equilibrium leaves open the reaction that an element follows.
bool is_open(const ActingElement& element,
             const std::vector<JointReaction>& joints) {
  const int followed = element.followed_joint();
  if (followed < 0) return false;
  const auto& unique =
      joints[static_cast<std::size_t>(followed)].unique_components;
  const bool is_guided = element.guide().length > 0.0;
  return !unique[0] || !unique[1] || (is_guided && (!unique[3] || !unique[4]));
}

/// Whether friction at rest holds more than the reaction lets it, as the
/// compliances share that.
bool exceeds_its_most(const ActingElement& element,
                      const ElementResponse& acting,
                      const std::vector<JointReaction>& joints) {
  constexpr double kMargin = 1e-6;
  const auto j = static_cast<std::size_t>(element.followed_joint());
  const double load = followed_force(element, acting.q, joints[j]);
  const double most = element.breakaway_per_load() * load;
  return std::abs(acting.effort) > (1.0 + kMargin) * most;
}

[[noreturn]] void refuse_open_load(const MechanismDefinition& definition,
                                   const ForceModel& forces, std::size_t k) {
  const ForceElement& element = definition.elements[k];
  const auto j = static_cast<std::size_t>(forces.element(k).followed_joint());
  const bool rests = some_friction_rests(forces);
  throw Error("K011", place_of(element),
              fmt::format("friction {} follows the reaction of joint {}, "
                          "which equilibrium leaves open{}",
                          name_of(element), definition.joints[j].name,
                          rests ? ": friction at rest shares it" : ""),
              rests ? "Give the friction itself, or model = \"regularized\"; "
                      "remove redundant constraints if there are any."
                    : "Remove redundant constraints (dimension = \"planar\" if "
                      "the mechanism moves in a plane), or give the friction "
                      "itself.");
}

/// Whether the guide of friction that slides carries a moment of which a motion
/// in the plane knows nothing.
bool is_pressed_across_plane(const ActingElement& element,
                             const ElementResponse& acting,
                             const std::vector<JointReaction>& joints) {
  constexpr double kOfLoad = 1e-3;
  if (!(element.guide().length > 0.0) || element.sticks()) return false;
  const auto j = static_cast<std::size_t>(element.followed_joint());
  const double load = followed_force(element, acting.q, joints[j]);
  return load - acting.load > kOfLoad * load;
}

}  // namespace

void require_unique_loads(const MechanismDefinition& definition,
                          const ForceModel& forces, const ForceState& acting,
                          const std::vector<JointReaction>& joints) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const ActingElement& element = forces.element(k);
    if (is_open(element, joints)) {
      const bool slides = std::abs(element.modes[0]) == 1;
      const bool fails =
          slides || (element.is_dry() &&
                     exceeds_its_most(element, acting.elements[k], joints));
      if (fails) refuse_open_load(definition, forces, k);
      continue;
    }
    if (is_pressed_across_plane(element, acting.elements[k], joints)) {
      const ForceElement& friction = definition.elements[k];
      throw Error(
          "K011", place_of(friction),
          with_its_joint(definition, friction) +
              " has a guide that loads beside the plane of motion press",
          "Take dimension = \"spatial\".");
    }
  }
}

void refuse_open_loads(const MechanismDefinition& definition,
                       const ForceModel& forces,
                       const std::vector<JointReaction>& joints) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (is_open(forces.element(k), joints)) {
      refuse_open_load(definition, forces, k);
    }
  }
}

void refuse_friction_beside_teeth(const MechanismDefinition& definition,
                                  MovedBy moved_by) {
  for (const ForceElement& element : definition.elements) {
    const ElementLine* line = line_of(element);
    if (line == nullptr || !properties(element).follows_reaction) continue;
    for (const CouplingDefinition& coupling : definition.couplings) {
      const bool is_known = coupling.teeth && moved_by == MovedBy::kDrives;
      if (is_known || (line->joint != coupling.joint_1 &&
                       line->joint != coupling.joint_2)) {
        continue;
      }
      const std::string& joint =
          definition.joints[static_cast<std::size_t>(line->joint)].name;
      throw Error(
          "K011", place_of(element),
          fmt::format(
              "friction {} follows the reaction of joint {}, which the "
              "teeth of coupling {} load: their force is not {}",
              name_of(element), joint, coupling.name,
              coupling.teeth ? "in a motion that forces decide" : "resolved"),
          coupling.teeth ? "Give the friction itself, or drive the motion by a "
                           "law."
                         : "Give the coupling its `pressure_angle`, or the "
                           "friction itself.");
    }
  }
}

void refuse_self_locking(const MechanismDefinition& definition,
                         std::size_t element, double t) {
  const ForceElement& jammed = definition.elements[element];
  throw Error("K011", place_of(jammed),
              fmt::format("at t = {:.9g} s {}, which follows the reaction, "
                          "jams: no friction, or more than one, fits the "
                          "motion",
                          t, with_its_joint(definition, jammed)),
              "Reduce the friction coefficient or the pin radius; rigid "
              "bodies have no answer here.");
}

}  // namespace clevis::mechanism
