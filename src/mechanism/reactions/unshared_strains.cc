#include "mechanism/reactions/unshared_strains.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/values/index.h"
#include "mechanism/force_elements/force_element.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

constexpr double kAlong = 0.1;  // of a unit vector: it has a share there

double largest_reaction(const Motion& motion) {
  double largest = 0.0;
  for (const Instant& instant : motion.instants) {
    for (const JointReaction& joint : instant.joints) {
      largest = std::max(largest, joint.f_W.norm());
    }
  }
  return largest;
}

std::vector<std::size_t> joints_of(const MechanismDefinition& definition,
                                   int body) {
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < definition.joints.size(); ++j) {
    const JointDefinition& joint = definition.joints[j];
    if (joint.body_a == body || joint.body_b == body) found.push_back(j);
  }
  return found;
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
double pull_of_spin(const MechanismDefinition& definition,
                    const Instant& instant, int body) {
  const double mass = definition.bodies[index(body)].mass_properties.mass;
  const Vector3d& spin = instant.bodies[index(body)].w_WL;
  const auto joints = joints_of(definition, body);
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

bool has_open_joint(const MechanismDefinition& definition,
                    const Instant& instant, int body) {
  return std::ranges::any_of(joints_of(definition, body), [&](std::size_t j) {
    return !instant.joints[j].unique;
  });
}

bool is_loaded(const MechanismDefinition& definition, const Instant& instant,
               int body) {
  for (std::size_t e = 0; e < definition.elements.size(); ++e) {
    if (acts_on(definition.elements[e], definition.joints, body) &&
        instant.elements[e].effort != 0.0) {
      return true;
    }
  }
  return false;
}

}  // namespace

UnsharedStrains unshared_strains(const MechanismDefinition& definition,
                                 const Motion& motion) {
  constexpr double kCounts = 0.01;
  const double counts = kCounts * largest_reaction(motion);
  UnsharedStrains found;
  for (int body = 0; body < static_cast<int>(definition.bodies.size());
       ++body) {
    const BodyDefinition& of = definition.bodies[index(body)];
    if (of.part.empty()) continue;  // rigid, as it is given
    const bool is_elastic = of.compliance.has_value();
    if (std::ranges::any_of(motion.instants, [&](const Instant& instant) {
          return is_elastic ? has_open_joint(definition, instant, body) &&
                                  is_loaded(definition, instant, body)
                            : pull_of_spin(definition, instant, body) > counts;
        })) {
      (is_elastic ? found.loaded : found.spun).push_back(body);
    }
  }
  return found;
}

}  // namespace clevis::mechanism
