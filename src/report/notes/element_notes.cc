#include "report/notes/element_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "report/notes/definition_notes.h"

namespace clevis::report {
namespace {

using mechanism::Actuation;
using mechanism::ElementAction;
using mechanism::ElementProperties;
using mechanism::ElementState;
using mechanism::ForceElement;
using mechanism::Instant;
using mechanism::MechanismDefinition;
using mechanism::Motion;

/// A force element over a motion.
struct ElementCourse {
  const MechanismDefinition& definition;
  const Motion& motion;
  std::size_t index{};
  const ForceElement& element;
  ElementProperties properties;
  bool is_angle{};
  double size{};  ///< of the mechanism [m]

  const ElementState& at(std::size_t instant) const {
    return motion.instants[instant].elements[index];
  }
  std::size_t instants() const { return motion.instants.size(); }
  /// Whether it touches or lets go, maybe between two instants.
  bool switches() const {
    const auto is_own = [this](const auto& event) {
      return event.element == static_cast<int>(index);
    };
    return std::ranges::any_of(motion.events, is_own) ||
           std::ranges::any_of(motion.impacts, is_own);
  }
  /// "contact wheel".
  std::string name() const {
    return fmt::format("{} {}", properties.type, name_of(element));
  }
  /// A position or a depth [m] or [rad].
  std::string amount(double value) const {
    return is_angle ? fmt::format("{:.4g} deg", value / kDegree)
                    : fmt::format("{:.4g} mm", value / kMilli);
  }

  static constexpr double kDegree = std::numbers::pi / 180.0, kMilli = 1e-3;
};

bool acts(const ElementState& state) {
  return state.effort != 0.0 || state.friction != 0.0 ||
         std::ranges::any_of(state.actions, [](const ElementAction& action) {
           return !action.f_W.isZero(0.0) || !action.t_W.isZero(0.0);
         });
}

/// Distance to the nearer end; below 0 it presses [m] or [rad].
double gap(const ElementProperties& properties, const ElementState& state) {
  double nearest = HUGE_VAL;
  if (properties.upper) nearest = *properties.upper - state.position;
  if (properties.lower) {
    nearest = std::min(nearest, state.position - *properties.lower);
  }
  return nearest;
}

/// As of an end in m that was meant in mm, or a normal that points away. Stops
/// that a motion comes near to are there for safety.
void add_untouched(const ElementCourse& course,
                   std::vector<std::string>& notes) {
  if (course.switches()) return;
  double nearest = HUGE_VAL, least = HUGE_VAL, most = -HUGE_VAL;
  for (std::size_t i = 0; i < course.instants(); ++i) {
    const ElementState& state = course.at(i);
    if (acts(state)) return;
    nearest = std::min(nearest, gap(course.properties, state));
    least = std::min(least, state.position);
    most = std::max(most, state.position);
  }
  const double travel = most - least;
  const double first = gap(course.properties, course.at(0));
  const double last = gap(course.properties, course.at(course.instants() - 1));
  const bool departs = travel > 0.0 && nearest == first && last > 2.0 * first;
  if (!std::isfinite(nearest) || (nearest <= travel && !departs)) return;
  notes.push_back(fmt::format(
      "{} never presses over the whole motion: it comes no nearer than {}{}. "
      "See that its place, its direction and their units are right",
      course.name(), course.amount(nearest),
      departs ? ", where it begins"
              : fmt::format(", while it moves by {}", course.amount(travel))));
}

void add_idle(const ElementCourse& course, std::vector<std::string>& notes) {
  if (course.instants() < 2) return;
  if (course.properties.presses) return add_untouched(course, notes);
  if (course.properties.actuation == Actuation::kNone) return;
  for (std::size_t i = 0; i < course.instants(); ++i) {
    if (acts(course.at(i))) return;
  }
  notes.push_back(fmt::format(
      "{} gives no effort over the whole motion of {:.4g} s: see that the "
      "units of its times and of the duration are right",
      course.name(), course.motion.instants.back().t));
}

/// As of an end on the wrong side, or a stiffness in N/m that was meant in
/// N/mm.
void add_deep(const ElementCourse& course, std::vector<std::string>& notes) {
  constexpr double kQuarterTurn = 90.0 * ElementCourse::kDegree;
  if (!course.properties.presses || course.instants() == 0) return;
  double bound = course.properties.size;
  const bool has_size = bound > 0.0;
  // One end alone may be a cord that is stretched.
  constexpr double kOfMechanism = 5.0;
  if (!has_size) {
    bound = course.is_angle ? kQuarterTurn : kOfMechanism * course.size;
  }
  if (bound == 0.0) return;
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < course.instants(); ++i) {
    if (gap(course.properties, course.at(i)) <
        gap(course.properties, course.at(deepest))) {
      deepest = i;
    }
  }
  const double at_start = -gap(course.properties, course.at(0));
  const double most = -gap(course.properties, course.at(deepest));
  if (!std::isfinite(most) || most <= bound) return;
  const std::string beside =
      fmt::format("deeper than {} {}",
                  !has_size && course.is_angle ? "a quarter turn,"
                  : !has_size ? "five times the mechanism's size,"
                  : course.properties.slides ? "its radius of"
                                             : "the range between its ends of",
                  course.amount(bound));
  notes.push_back(
      at_start > bound
          ? fmt::format(
                "{} is {} deep at the start, {}: see that its place and its "
                "direction are right",
                course.name(), course.amount(at_start), beside)
          : fmt::format("{} is pressed {} deep at {:.4g} s, {}: see that its "
                        "stiffness is right",
                        course.name(), course.amount(most),
                        course.motion.instants[deepest].t, beside));
}

/// As of a free length in m that was meant in mm.
void add_stretched(const ElementCourse& course,
                   std::vector<std::string>& notes) {
  constexpr double kTimes = 10.0;
  if (!course.properties.free || course.is_angle || course.size == 0.0) return;
  double most = 0.0;
  for (std::size_t i = 0; i < course.instants(); ++i) {
    most = std::max(most,
                    std::abs(course.at(i).position - *course.properties.free));
  }
  if (most <= kTimes * course.size) return;
  notes.push_back(fmt::format(
      "{} is {} off the position where it gives no force, {:.3g} times the "
      "mechanism's size ({}): see that its lengths are right",
      course.name(), course.amount(most), most / course.size,
      course.amount(course.size)));
}

/// As of a point in m that was meant in mm.
void add_far(const ElementCourse& course, std::vector<std::string>& notes) {
  constexpr double kTimes = 10.0;
  if (course.size == 0.0) return;
  double most = 0.0;
  mechanism::BodyIndex farthest = mechanism::kGround;
  for (const Instant& instant : course.motion.instants) {
    for (const ElementAction& action : instant.elements[course.index].actions) {
      if (action.body == mechanism::kGround || action.f_W.isZero(0.0)) continue;
      const auto body = static_cast<std::size_t>(action.body);
      const part::Pose& pose = instant.bodies[body].pose;
      const Eigen::Vector3d centre =
          pose.p_WL +
          pose.R_WL * course.definition.bodies[body].mass_properties.p_LCm;
      const double distance = (action.p_W - centre).norm();
      if (distance <= most) continue;
      most = distance;
      farthest = action.body;
    }
  }
  if (most <= kTimes * course.size) return;
  notes.push_back(fmt::format(
      "{} acts {:.4g} mm from the centre of mass of body {}, {:.3g} times the "
      "mechanism's size: see that its point is right",
      course.name(), most / ElementCourse::kMilli,
      course.definition.bodies[static_cast<std::size_t>(farthest)].name,
      most / course.size));
}

/// Rubber on rough ground has up to 1.5.
void add_friction(const ElementCourse& course,
                  std::vector<std::string>& notes) {
  constexpr double kMost = 2.0, kOfSize = 0.3;
  const double friction = course.properties.friction;
  if (course.properties.follows_reaction && course.is_angle) {
    if (course.size == 0.0 || friction <= kOfSize * course.size) return;
    notes.push_back(fmt::format(
        "{}: a newton in its joint holds against {:.4g} N mm, as if at an arm "
        "of the mechanism's size: see that its radius and its coefficient are "
        "right",
        course.name(), friction / ElementCourse::kMilli));
  } else if (friction > kMost) {
    notes.push_back(fmt::format(
        "{} has a coefficient of friction of {:.4g}: dry surfaces have less "
        "than {:.4g}",
        course.name(), friction, kMost));
  }
}

/// A guide of length L carries a moment M across its axis by forces M/L at its
/// ends: where these are more than half of the force F, they press with 2 M/L.
void add_overhang(const ElementCourse& course,
                  std::vector<std::string>& notes) {
  constexpr double kOfSize = 0.05, kOfLargest = 0.05;
  const auto& properties = course.properties;
  if (!properties.follows_reaction || course.is_angle ||
      properties.guide_length > 0.0) {
    return;
  }
  const auto joint =
      static_cast<std::size_t>(mechanism::line_of(course.element)->joint);
  const auto of = [&](const Instant& instant) {
    const auto components = instant.joints[joint].components();
    return std::pair(components.head<2>().norm(),
                     components.segment<2>(3).norm());
  };
  double largest = 0.0;  // of the moments [N m]
  for (const Instant& instant : course.motion.instants) {
    largest = std::max(largest, of(instant).second);
  }
  double longest = kOfSize * course.size, force = 0.0, moment = 0.0;
  for (const Instant& instant : course.motion.instants) {
    const auto [f, m] = of(instant);
    if (m < kOfLargest * largest || 2.0 * m <= longest * f) continue;
    longest = f > 0.0 ? 2.0 * m / f : HUGE_VAL;
    force = f;
    moment = m;
  }
  if (moment == 0.0) return;
  notes.push_back(fmt::format(
      "{} follows the force across joint {}, {:.4g} N, not the moment across "
      "it, {:.4g} N m, with which {} presses at its ends: give its guide = "
      "{{ body, length }}",
      course.name(), course.definition.joints[joint].name, force, moment,
      std::isinf(longest) ? "any guide"
                          : fmt::format("a guide shorter than {:.4g} mm",
                                        longest / ElementCourse::kMilli)));
}

void add_gas(const ElementCourse& course, std::vector<std::string>& notes) {
  constexpr double kColdest = 60.0, kHottest = 3000.0;   // [K]
  constexpr double kThinnest = 1.0, kDensest = 200.0e6;  // [Pa]
  for (const Instant& instant : course.motion.instants) {
    for (const auto& chamber : instant.elements[course.index].chambers) {
      const bool is_gas =
          kColdest <= chamber.temperature && chamber.temperature <= kHottest &&
          kThinnest <= chamber.pressure && chamber.pressure <= kDensest;
      if (is_gas) continue;
      notes.push_back(fmt::format(
          "{} has gas of {:.4g} MPa and {:.4g} K at {:.4g} s, where no ideal "
          "gas is: see that its pressures, temperatures and areas are right",
          course.name(), 1e-6 * chamber.pressure, chamber.temperature,
          instant.t));
      return;
    }
  }
}

}  // namespace

void add_element_notes(const MechanismDefinition& definition,
                       const Motion& motion, std::vector<std::string>& notes) {
  if (motion.instants.empty()) return;
  const double size = mechanism_size(definition);
  for (std::size_t k = 0; k < definition.elements.size(); ++k) {
    const ForceElement& element = definition.elements[k];
    const ElementCourse course{.definition = definition,
                               .motion = motion,
                               .index = k,
                               .element = element,
                               .properties = properties(element),
                               .is_angle = is_angle(element, definition.joints),
                               .size = size};
    for (const auto add : {add_idle, add_deep, add_stretched, add_far,
                           add_friction, add_overhang, add_gas}) {
      add(course, notes);
    }
  }
}

}  // namespace clevis::report
