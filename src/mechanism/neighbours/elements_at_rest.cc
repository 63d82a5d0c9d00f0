#include "mechanism/neighbours/elements_at_rest.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
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
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double kRoundOff = 1e-9;  // of rows of pure numbers
constexpr double kAtRest = 1e-6;    // [m/s], [rad/s]

/// What friction is proportional to: 1, or the force that it follows [N].
/// @param q  of its line [m] or [rad].
double load_of(const ActingElement& element, double q, const Instant& instant) {
  const int followed = element.followed_joint();
  return followed < 0
             ? 1.0
             : followed_force(element, q, instant.joints[index(followed)]);
}

/// Of a unit effort on one body that nothing else holds, 1/m [1/kg]. What has
/// no inertia of its own is held by others.
double mobility(const Neighbours& neighbours, const Configuration& x, int slot,
                const SpatialForce& lever) {
  if (slot == 0) return 0.0;
  const auto& mass =
      neighbours.definition().bodies[index(slot - 1)].mass_properties;
  const Vector3d turn = x[index(slot)].R.transpose() * lever.w;
  const double inertia = turn.dot(mass.inertia_LCm * turn);
  const double square = turn.squaredNorm();
  return (mass.mass > 0.0 ? lever.v.squaredNorm() / mass.mass : 0.0) +
         (inertia > 0.0 ? square * square / inertia : 0.0);
}

}  // namespace

double free_period(const Neighbours& neighbours, std::size_t element,
                   const Instant& instant) {
  const auto& acting = *neighbours.elements()[element];
  const auto x = configuration_at(neighbours.frame(), instant);
  const auto spring = acting.spring(x, instant.elements[element]);
  if (spring.directions.empty()) return HUGE_VAL;
  const auto& levers = spring.directions.front();
  const double square = spring.stiffness(0, 0) *
                        (mobility(neighbours, x, acting.line.a, levers.a) +
                         mobility(neighbours, x, acting.line.b, levers.b));
  return square > 0.0 ? 2.0 * std::numbers::pi / std::sqrt(square) : HUGE_VAL;
}

Sticking sticking(const MechanismDefinition& definition,
                  const Instant& instant) {
  Sticking found;
  std::optional<SolvingFrame> frame;
  Configuration x;
  std::vector<DriveDefinition> drives = definition.drives;
  std::vector<Eigen::VectorXd> rows;  // of lines
  const auto system_of = [&] {
    return ConstraintSystem(*frame, drives, Motions::kSpatial,
                            ConstraintSystem::Drives::kAll);
  };
  const auto freedom = [&] {
    const ConstraintSystem system = system_of();
    MatrixXd J = system.jacobian(system.place(x));
    for (const Eigen::VectorXd& row : rows) {
      J.conservativeResize(J.rows() + 1, Eigen::NoChange);
      J.bottomRows(1) = row.transpose();
    }
    return null_space(J, kRoundOff).cols();
  };
  Index left = 0;
  const std::size_t count =
      std::min(instant.elements.size(), definition.elements.size());
  for (std::size_t e = 0; e < count; ++e) {
    const ElementLine* line = line_of(definition.elements[e]);
    if (line == nullptr || std::abs(instant.elements[e].rate) > kAtRest) {
      continue;
    }
    if (!frame) frame.emplace(frame_at_centres(definition));
    const auto placed = place(definition.elements[e], *frame);
    if (!placed->is_dry()) continue;
    if (x.empty()) {
      x = configuration_at(*frame, instant);
      left = freedom();
    }
    const bool is_joint = line->kind == ElementLine::Kind::kJoint;
    if (is_joint) {
      DriveDefinition& drive = drives.emplace_back();
      drive.joint = line->joint;
      drive.coordinate = line->coordinate;
    } else {
      rows.push_back(row_along(*placed, x, system_of()));
    }
    const Index now = freedom();
    if (now < left) {
      left = now;
      if (is_joint) {
        found.coordinates.push_back(drives.back());
      } else {
        found.lines.push_back(e);
      }
    } else if (is_joint) {
      drives.pop_back();
    } else {
      rows.pop_back();
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
        {instant.t, load_of(*placed, state.position, instant), sway, state});
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
