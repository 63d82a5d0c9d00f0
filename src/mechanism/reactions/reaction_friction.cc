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

}  // namespace

double force_across(const JointReaction& reaction) {
  return reaction.components().head<2>().norm();
}

Equilibrium::Solution balance_with_friction(
    const ForceModel& forces, ForceState& acting, std::size_t slots,
    const std::function<Equilibrium::Solution(std::span<const Twist>)>&
        balance) {
  constexpr int kMost = 300;
  std::vector<SpatialForce> applied(slots);
  forces.add_to(acting, applied);
  Equilibrium::Solution solution = balance(applied);
  for (int i = 0; i < kMost; ++i) {
    double change = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const int joint = forces.element(k).followed_joint();
      if (joint < 0) continue;
      const auto& reaction = solution.joints[static_cast<std::size_t>(joint)];
      ElementResponse& element = acting.elements[k];
      const double before = element.load;
      const double load = force_across(reaction);
      give_load(forces.element(k), load, element);
      change = std::max(change, std::abs(load - before));
      largest = std::max(largest, load);
    }
    if (!std::isfinite(largest)) break;
    if (change <= kSettled * largest) return solution;
    std::ranges::fill(applied, Twist{});
    forces.add_to(acting, applied);
    solution = balance(applied);
  }
  throw Error("K011", "mechanism",
              "joint friction that follows the reaction grows with it without "
              "bound",
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
  return !unique[0] || !unique[1];
}

/// Whether friction at rest holds more than the reaction lets it, as the
/// compliances share that.
bool exceeds_its_most(const ActingElement& element,
                      const ElementResponse& acting,
                      const std::vector<JointReaction>& joints) {
  constexpr double kMargin = 1e-6;
  const auto j = static_cast<std::size_t>(element.followed_joint());
  const double load = force_across(joints[j]);
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

}  // namespace

void require_unique_loads(const MechanismDefinition& definition,
                          const ForceModel& forces, const ForceState& acting,
                          const std::vector<JointReaction>& joints) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const ActingElement& element = forces.element(k);
    if (!is_open(element, joints)) continue;
    const bool slides = std::abs(element.modes[0]) == 1;
    const bool fails =
        slides || (element.is_dry() &&
                   exceeds_its_most(element, acting.elements[k], joints));
    if (fails) refuse_open_load(definition, forces, k);
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

void refuse_self_locking(double t) {
  throw Error("K011", "mechanism",
              fmt::format("at t = {:.9g} s joint friction that follows the "
                          "reaction jams: no friction, or more than one, fits "
                          "the motion",
                          t),
              "Reduce the friction coefficient or the pin radius; rigid "
              "bodies have no answer here.");
}

}  // namespace clevis::mechanism
