#include "mechanism/reactions/unshared_strains.h"

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <vector>

#include "base/values/index.h"
#include "mechanism/reactions/largest_reaction.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

constexpr double kAlong = 0.1;  // of a unit vector: it has a share there

using Joints = std::vector<std::size_t>;

/// Those of each body with a part that some instant leaves open.
std::vector<Joints> open_joints(const MechanismDefinition& definition,
                                const Motion& motion) {
  std::vector<Joints> by_body(definition.bodies.size());
  for (std::size_t j = 0; j < definition.joints.size(); ++j) {
    if (std::ranges::all_of(motion.instants, [&](const Instant& instant) {
          return instant.joints[j].unique;
        })) {
      continue;
    }
    const JointDefinition& joint = definition.joints[j];
    for (const BodyIndex body : {joint.body_a, joint.body_b}) {
      // Without a part it is rigid, as it is given.
      if (body == kGround || definition.bodies[index(body)].part.empty()) {
        continue;
      }
      by_body[index(body)].push_back(j);
    }
  }
  return by_body;
}

/// Whether an open force of a joint has a share along a line, and not along
/// the spin.
bool is_open_along(const JointReaction& joint, const Vector3d& line,
                   const Vector3d& spin) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (joint.unique_components[k]) continue;
    const Vector3d axis = joint.R_WJ.col(static_cast<Eigen::Index>(k));
    if (std::abs(axis.dot(line)) > kAlong &&
        axis.cross(spin).norm() > kAlong * spin.norm()) {
      return true;
    }
  }
  return false;
}

/// The largest m ω² d/8 between two joints of open forces [N].
double pull_of_spin(double mass, const Vector3d& spin, const Joints& joints,
                    const Instant& instant) {
  double largest = 0.0;
  for (std::size_t a = 0; a < joints.size(); ++a) {
    for (std::size_t b = a + 1; b < joints.size(); ++b) {
      const JointReaction& one = instant.joints[joints[a]];
      const JointReaction& other = instant.joints[joints[b]];
      const Vector3d way = other.p_WJ - one.p_WJ;
      const Vector3d line = way.normalized();
      if (is_open_along(one, line, spin) && is_open_along(other, line, spin)) {
        const double across = spin.cross(line).squaredNorm();
        largest = std::max(largest, mass * across * way.norm() / 8.0);
      }
    }
  }
  return largest;
}

/// Whether a force acts on an elastic link that its compliance does not know.
bool is_loaded(const LinkCompliance& link, const Instant& instant, int body) {
  for (int k = 0; k < static_cast<int>(instant.elements.size()); ++k) {
    if (std::ranges::find(link.loads, k, &LinkLoad::element) !=
        link.loads.end()) {
      continue;
    }
    if (std::ranges::any_of(instant.elements[index(k)].actions,
                            [body](const ElementAction& action) {
                              return action.body == body &&
                                     !(action.f_W.isZero(0.0) &&
                                       action.t_W.isZero(0.0));
                            })) {
      return true;
    }
  }
  return false;
}

}  // namespace

UnsharedStrains unshared_strains(const MechanismDefinition& definition,
                                 const Motion& motion, double length) {
  constexpr double kCounts = 0.01;
  const auto beside = reactions_beside(definition.joints, motion, length);
  const std::vector<Joints> open = open_joints(definition, motion);
  UnsharedStrains found;
  for (int body = 0; body < static_cast<int>(open.size()); ++body) {
    const Joints& joints = open[index(body)];
    if (joints.empty()) continue;
    const double counts =
        kCounts * std::ranges::min(
                      joints | std::views::transform([&beside](std::size_t j) {
                        return beside[j];
                      }));
    const BodyDefinition& of = definition.bodies[index(body)];
    const auto& elastic = of.compliance;
    if (std::ranges::any_of(motion.instants, [&](const Instant& instant) {
          return elastic ? is_loaded(*elastic, instant, body)
                         : pull_of_spin(of.mass_properties.mass,
                                        instant.bodies[index(body)].w_WL,
                                        joints, instant) > counts;
        })) {
      (elastic ? found.loaded : found.spun).push_back(body);
    }
  }
  return found;
}

}  // namespace clevis::mechanism
