#include "mechanism/structure/joined_bodies.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
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

/// Whether a joint and the drives on it leave no motion between its bodies but
/// what they prescribe.
bool is_stiff(const MechanismDefinition& mechanism, std::size_t joint) {
  constexpr std::ptrdiff_t kMotions = 6;
  const auto held = std::ssize(
      constrained_rows(mechanism.joints[joint].type, Motions::kSpatial));
  const auto driven = std::ranges::count(
      mechanism.drives, static_cast<int>(joint), &DriveDefinition::joint);
  return held + driven == kMotions;
}

template <class Unites>
std::vector<std::vector<BodyIndex>> united(const MechanismDefinition& mechanism,
                                           const Unites& unites) {
  BodySets sets(mechanism.bodies.size());
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const JointDefinition& joint = mechanism.joints[j];
    if (joint.body_a == kGround || joint.body_b == kGround || !unites(j)) {
      continue;
    }
    sets.unite(index(joint.body_a), index(joint.body_b));
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
  const auto any = [](std::size_t) {
    return true;
  };
  const auto stiff = [&](std::size_t joint) {
    return is_stiff(mechanism, joint);
  };
  return {united(mechanism, any), united(mechanism, stiff)};
}

}  // namespace clevis::mechanism
