#include "mechanism/neighbours/elements_at_rest.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/algebra/singular_vectors.h"
#include "base/values/index.h"
#include "mechanism/mass_matrix/centre_frame.h"
#include "mechanism/neighbours/neighbours.h"
#include "mechanism/reactions/reaction_friction.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;

constexpr double kRoundOff = 1e-9;  // of rows of pure numbers
constexpr double kAtRest = 1e-6;    // [m/s], [rad/s]

/// What friction is proportional to: 1, or the force that it follows [N].
double load_of(const ActingElement& element, const Instant& instant) {
  const int followed = element.followed_joint();
  return followed < 0 ? 1.0 : force_across(instant.joints[index(followed)]);
}

}  // namespace

std::vector<DriveDefinition> sticking_coordinates(
    const MechanismDefinition& definition, const Instant& instant) {
  std::vector<DriveDefinition> found;
  std::optional<SolvingFrame> frame;
  Configuration x;
  std::vector<DriveDefinition> drives = definition.drives;
  const auto freedom = [&] {
    const ConstraintSystem system(*frame, drives, Motions::kSpatial,
                                  ConstraintSystem::Drives::kAll);
    return null_space(system.jacobian(system.place(x)), kRoundOff).cols();
  };
  Index left = 0;
  const std::size_t count =
      std::min(instant.elements.size(), definition.elements.size());
  for (std::size_t e = 0; e < count; ++e) {
    const ElementLine* line = line_of(definition.elements[e]);
    if (line == nullptr || line->kind != ElementLine::Kind::kJoint ||
        std::abs(instant.elements[e].rate) > kAtRest) {
      continue;
    }
    if (!frame) frame.emplace(frame_at_centres(definition));
    if (!place(definition.elements[e], *frame)->is_dry()) continue;
    if (x.empty()) {
      x = configuration_at(*frame, instant);
      left = freedom();
    }
    DriveDefinition sticking;
    sticking.joint = line->joint;
    sticking.coordinate = line->coordinate;
    drives.push_back(sticking);
    const Index now = freedom();
    if (now < left) {
      found.push_back(sticking);
      left = now;
    } else {
      drives.pop_back();
    }
  }
  return found;
}

std::optional<MechanismDefinition> yielding_at_rest(
    const MechanismDefinition& definition, const Instant& instant) {
  constexpr double kSway = 1.0 / 200.0;  // [rad]
  std::optional<MechanismDefinition> yielding;
  const SolvingFrame frame = frame_at_centres(definition);
  const std::size_t count =
      std::min(instant.elements.size(), definition.elements.size());
  for (std::size_t e = 0; e < count; ++e) {
    const ForceElement& element = definition.elements[e];
    const ElementState& state = instant.elements[e];
    const ElementLine* line = line_of(element);
    if (line == nullptr || std::abs(state.rate) > kAtRest) continue;
    const auto placed = place(element, frame);
    const double sway =
        is_angle(element, definition.joints) ? kSway : kSway * frame.length;
    const auto stiffness = placed->slow_stiffness(
        {instant.t, load_of(*placed, instant), sway, state});
    if (!stiffness) continue;
    LineElement spring;
    spring.name = name_of(element);
    spring.line = *line;
    spring.place = place_of(element);
    spring.law = SpringLaw{.stiffness = *stiffness, .free = state.position};
    if (!yielding) yielding = definition;
    yielding->elements[e] = std::move(spring);
  }
  return yielding;
}

}  // namespace clevis::mechanism
