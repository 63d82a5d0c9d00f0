#include "mechanism/structure/joined_bodies.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "base/values/index.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {
namespace {

/// Bodies as sets that joints unite.
class BodySets {
 public:
  explicit BodySets(std::size_t bodies) : parent_(bodies) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t body) const {
    while (parent_[body] != body) body = parent_[body];
    return body;
  }
  void unite(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// Turns between a joint's bodies that it or its drives prescribe.
std::ptrdiff_t held_by_joint(const MechanismDefinition& mechanism,
                             std::size_t joint) {
  const JointType type = mechanism.joints[joint].type;
  return std::ranges::count_if(constrained_rows(type, Motions::kSpatial),
                               &JointRow::is_angle) +
         std::ranges::count_if(
             mechanism.drives, [&](const DriveDefinition& drive) {
               return drive.joint == static_cast<int>(joint) &&
                      coordinate_row(type, drive.coordinate).is_angle();
             });
}

/// Whether a joint with so many turns held hands bending on: what slides along
/// an axis may turn about it. Not a rod on gas in its cylinder that no drive
/// moves: what both bear together is not known well enough.
bool hands_on(const MechanismDefinition& mechanism, std::size_t joint,
              std::ptrdiff_t turns) {
  const auto number = static_cast<int>(joint);
  const JointType type = mechanism.joints[joint].type;
  if (traits(type).slide_directions != 1) return turns >= 3;
  const bool is_driven =
      std::ranges::any_of(mechanism.drives, [&](const DriveDefinition& drive) {
        return drive.joint == number;
      });
  const bool is_on_gas =
      std::ranges::any_of(mechanism.elements, [&](const ForceElement& element) {
        const ElementLine* line = line_of(element);
        return line != nullptr && line->kind == ElementLine::Kind::kJoint &&
               line->joint == number && properties(element).gas != nullptr;
      });
  return turns >= 2 && (is_driven || !is_on_gas);
}

/// Whether an element yields about a position; gas only presses.
bool holds_position(const ForceElement& element) {
  const ElementProperties given = properties(element);
  return given.free || given.reference != nullptr;
}

/// Angles of a joint about which force elements hold a position: along a slide
/// they hand no moment on.
std::ptrdiff_t held_by_elements(const MechanismDefinition& mechanism,
                                std::size_t joint) {
  std::set<int> coordinates;
  for (const ForceElement& element : mechanism.elements) {
    const ElementLine* line = line_of(element);
    if (line != nullptr && line->kind == ElementLine::Kind::kJoint &&
        line->joint == static_cast<int>(joint) && holds_position(element) &&
        is_angle(element, mechanism.joints)) {
      coordinates.insert(line->coordinate);
    }
  }
  return std::ssize(coordinates);
}

using Pairs = std::vector<std::pair<BodyIndex, BodyIndex>>;

/// Bodies of the joints for which something holds.
template <class Unites>
Pairs joined_by(const MechanismDefinition& mechanism, const Unites& unites) {
  Pairs pairs;
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const JointDefinition& joint = mechanism.joints[j];
    if (unites(j)) pairs.emplace_back(joint.body_a, joint.body_b);
  }
  return pairs;
}

std::vector<std::vector<BodyIndex>> united(const MechanismDefinition& mechanism,
                                           const Pairs& pairs) {
  BodySets sets(mechanism.bodies.size());
  for (const auto& [a, b] : pairs) {
    if (a != kGround && b != kGround) sets.unite(index(a), index(b));
  }
  std::map<std::size_t, std::vector<BodyIndex>> groups;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    groups[sets.of(b)].push_back(static_cast<BodyIndex>(b));
  }
  std::vector<std::vector<BodyIndex>> result;
  for (auto& [set, bodies] : groups) {
    if (bodies.size() > 1) result.push_back(std::move(bodies));
  }
  return result;
}

}  // namespace

JoinedBodies joined_bodies(const MechanismDefinition& mechanism) {
  const Pairs all = joined_by(mechanism, [](std::size_t) {
    return true;
  });
  const Pairs stiff = joined_by(mechanism, [&](std::size_t joint) {
    return hands_on(mechanism, joint, held_by_joint(mechanism, joint));
  });
  Pairs elastic = joined_by(mechanism, [&](std::size_t joint) {
    return hands_on(
        mechanism, joint,
        held_by_joint(mechanism, joint) + held_by_elements(mechanism, joint));
  });
  for (const ForceElement& element : mechanism.elements) {
    if (line_of(element) != nullptr || !holds_position(element)) continue;
    const auto [a, b] = bodies_of(element, mechanism.joints);
    elastic.emplace_back(a, b);
  }
  return {united(mechanism, all), united(mechanism, stiff),
          united(mechanism, elastic)};
}

}  // namespace clevis::mechanism
