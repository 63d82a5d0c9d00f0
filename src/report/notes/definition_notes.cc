#include "report/notes/definition_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "mechanism/definition/pitch_radii.h"
#include "part/gyration.h"

namespace clevis::report {
namespace {

using Eigen::Vector3d;
using mechanism::BodyDefinition;
using mechanism::MechanismDefinition;

/// The moon has 1.6 m/s², Jupiter 25; 9810 were meant as mm/s².
void add_gravity(const MechanismDefinition& definition,
                 std::vector<std::string>& notes) {
  constexpr double kEarth = 9.81, kLeast = 1.0, kLargest = 30.0;  // [m/s²]
  const double gravity = definition.gravity_W.norm();
  if (gravity == 0.0 || (kLeast <= gravity && gravity <= kLargest)) return;
  notes.push_back(fmt::format(
      "gravity is {:.4g} m/s^2, {:.4g} times the earth's: see that its unit is "
      "right",
      gravity, gravity / kEarth));
}

/// Of the ellipsoid that has a body's mass and inertia [kg/m³]. Of all bodies
/// of one density the ellipsoid has the least inertia: no body is less dense.
/// @param least  semi-axis, over the largest: inertias of laminae and of rods
///               are given without it [1].
double density_of_ellipsoid(const part::MassProperties& given, double least) {
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                               given.inertia_LCm, Eigen::EigenvaluesOnly)
                               .eigenvalues();
  const Vector3d squares =
      (5.0 / given.mass *
       (Vector3d::Constant(0.5 * moments.sum()) - moments).array())
          .max(0.0);
  const Vector3d axes = squares.cwiseSqrt();
  return given.mass / (4.0 / 3.0 * std::numbers::pi *
                       axes.cwiseMax(least * axes.maxCoeff()).prod());
}

/// Bodies that are given as all but points are spared.
void add_densities(const MechanismDefinition& definition,
                   std::vector<std::string>& notes) {
  constexpr double kLargest = 10.0 * 25000.0;  // [kg/m³], of materials: 25000
  constexpr double kLeast = 10.0;  // frames of thin tubes have more [kg/m³]
  constexpr double kThick = 1.0 / 20.0, kThin = 1.0 / 50.0;
  for (const BodyDefinition& body : definition.bodies) {
    const part::MassProperties& given = body.mass_properties;
    if (!body.part.empty() || !(given.mass > 0.0) ||
        !(given.inertia_LCm.trace() > 0.0)) {
      continue;
    }
    const double most = density_of_ellipsoid(given, kThin);
    const double least = density_of_ellipsoid(given, kThick);
    if (least > kLargest) {
      notes.push_back(fmt::format(
          "body {} of {:.4g} kg has so little inertia that it would have "
          "{:.2g} kg/m^3 at least: see that the units of its mass and inertia "
          "are right",
          body.name, given.mass, least));
    } else if (most < kLeast) {
      notes.push_back(fmt::format(
          "body {} of {:.4g} kg has so much inertia that it would have {:.2g} "
          "kg/m^3 as a solid: see that the units of its mass and inertia are "
          "right",
          body.name, given.mass, most));
    }
  }
}

/// Places of a body's joints on it [m].
std::vector<Vector3d> joints_on(const MechanismDefinition& definition,
                                std::size_t body) {
  std::vector<Vector3d> places;
  for (const auto& joint : definition.joints) {
    for (const auto& [on, frame] : {std::pair(joint.body_a, joint.frame_a),
                                    std::pair(joint.body_b, joint.frame_b)}) {
      if (on == static_cast<int>(body)) places.push_back(frame.p_LJ);
    }
  }
  return places;
}

/// As of m that were meant as mm. Meshes tell the centres of parts.
void add_far_centres(const MechanismDefinition& definition,
                     std::vector<std::string>& notes) {
  constexpr double kFar = 3.0, kMilli = 1e-3;
  constexpr double kFarOfSize = 1000.0;  // as of a small bob on a long cord
  for (std::size_t b = 0; b < definition.bodies.size(); ++b) {
    const BodyDefinition& body = definition.bodies[b];
    if (!body.part.empty()) continue;
    double span = 0.0, distance = HUGE_VAL;
    const std::vector<Vector3d> places = joints_on(definition, b);
    for (const Vector3d& place : places) {
      distance =
          std::min(distance, (place - body.mass_properties.p_LCm).norm());
      for (const Vector3d& other : places) {
        span = std::max(span, (place - other).norm());
      }
    }
    const double size = 2.0 * part::radius_of_mass(body.mass_properties);
    if (span == 0.0 && size > 0.0 && !places.empty() &&
        distance > kFarOfSize * size) {
      notes.push_back(fmt::format(
          "the centre of mass of body {} is {:.4g} mm from its joint, {:.3g} "
          "times the {:.4g} mm that its inertia tells of its size: see that "
          "its unit is right",
          body.name, distance / kMilli, distance / size, size / kMilli));
    }
    if (span == 0.0 || distance <= kFar * span) continue;
    notes.push_back(fmt::format(
        "the centre of mass of body {} is {:.4g} mm from its nearest joint, "
        "{:.3g} times as far as its joints are apart ({:.4g} mm): see that its "
        "unit is right",
        body.name, distance / kMilli, distance / span, span / kMilli));
  }
}

/// Bodies that no joint holds, where others are held.
void add_unjoined(const MechanismDefinition& definition,
                  std::vector<std::string>& notes) {
  if (definition.joints.empty()) return;
  for (std::size_t b = 0; b < definition.bodies.size(); ++b) {
    const bool is_joined =
        std::ranges::any_of(definition.joints, [&](const auto& joint) {
          return joint.body_a == static_cast<int>(b) ||
                 joint.body_b == static_cast<int>(b);
        });
    if (is_joined) continue;
    notes.push_back(
        fmt::format("body {} has no joint, forces alone move it: join it, or "
                    "leave it out if that is not meant",
                    definition.bodies[b].name));
  }
}

/// Teeth far beside their wheel's joint bend its shaft by a unit, not a load.
void add_far_teeth(const MechanismDefinition& definition,
                   std::vector<std::string>& notes) {
  constexpr double kFar = 10.0;  // radii of the larger wheel
  for (const auto& coupling : definition.couplings) {
    if (!coupling.teeth || !coupling.teeth->mid_face) continue;
    const double radius =
        std::ranges::max(mechanism::pitch_radii(definition.joints, coupling));
    const double away = std::abs(*coupling.teeth->mid_face);
    if (away <= kFar * radius) continue;
    notes.push_back(fmt::format(
        "coupling {}: its teeth stand {:.4g} mm beside its joint, {:.3g} times "
        "their pitch radius: see that the unit of mid_face is right",
        coupling.name, 1e3 * away, away / radius));
  }
}

}  // namespace

void add_definition_notes(const MechanismDefinition& definition,
                          std::vector<std::string>& notes) {
  add_gravity(definition, notes);
  add_densities(definition, notes);
  add_far_centres(definition, notes);
  add_unjoined(definition, notes);
  add_far_teeth(definition, notes);
}

double mechanism_size(const MechanismDefinition& definition) {
  double length = 0.0;
  for (const BodyDefinition& body : definition.bodies) {
    length = std::max(length, 2.0 * part::radius_of_mass(body.mass_properties));
  }
  for (const auto& joint : definition.joints) {
    for (const auto& [body, frame] : {std::pair(joint.body_a, joint.frame_a),
                                      std::pair(joint.body_b, joint.frame_b)}) {
      if (body != mechanism::kGround) {
        length = std::max(length, frame.p_LJ.norm());
      }
    }
  }
  return length;
}

}  // namespace clevis::report
