#include "scene/motion/plausible_mechanism.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::scene {
namespace {

using Eigen::Vector3d;
using mechanism::BodyDefinition;
using mechanism::JointDefinition;
using mechanism::MechanismDefinition;

constexpr double kLeastMass = 1e-30, kLargestMass = 1e12;  // [kg]
constexpr double kLargestLength = 1e6;                     // [m]
constexpr double kLargestLead = 1e3;                       // [m]
/// A flywheel on a short crank has 10, a reflected rotor some 30.
constexpr double kLargestGyration = 100.0;  // of the mechanism's length

[[noreturn]] void refuse(const std::string& place, const std::string& problem) {
  throw Error("S011", place, problem, "Check the number and its unit.");
}

void require_length(const Vector3d& p, const std::string& place,
                    const std::string& what) {
  if (p.norm() <= kLargestLength) return;
  refuse(place, fmt::format("{} lies {:.3g} km away, beyond any machine", what,
                            p.norm() / 1e3));
}

/// Largest distance of a body's joints from one another and from its centre
/// of mass [m]; 0: not known, for a part hangs on one joint, and its mesh alone
/// tells how far it reaches. A body on one joint may be a rotor out of balance:
/// its centre is no link's length.
double link_length(const MechanismDefinition& mechanism) {
  constexpr double kRotor = 0.05;  // [m]
  double longest = 0.0;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const BodyDefinition& body = mechanism.bodies[i];
    std::vector<Vector3d> points;
    if (body.part.empty()) points.push_back(body.mass_properties.p_LCm);
    for (const JointDefinition& joint : mechanism.joints) {
      const auto index = static_cast<mechanism::BodyIndex>(i);
      if (joint.body_a == index) points.push_back(joint.frame_a.p_LJ);
      if (joint.body_b == index) points.push_back(joint.frame_b.p_LJ);
    }
    if (!body.part.empty() && points.size() < 2) return 0.0;
    if (body.part.empty() && points.size() == 2) {
      longest = std::max(longest, kRotor);
    }
    for (const Vector3d& p : points) {
      for (const Vector3d& q : points) {
        longest = std::max(longest, (p - q).norm());
      }
    }
  }
  return longest;
}

void require_plausible(const BodyDefinition& body, double length) {
  const std::string name = "body \"" + body.name + "\"";
  require_length(body.placement.p_WL, body.place, name);
  if (!body.part.empty()) return;  // its mesh tells
  const part::MassProperties& m = body.mass_properties;
  require_length(m.p_LCm, body.place, "the centre of mass of " + name);
  if (m.mass < kLeastMass || m.mass > kLargestMass) {
    refuse(body.place, fmt::format("{} has a mass of {:.3g} kg, no machine's",
                                   name, m.mass));
  }
  const double largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                             m.inertia_LCm, Eigen::EigenvaluesOnly)
                             .eigenvalues()[2];
  const double gyration = std::sqrt(largest / m.mass);
  if (length == 0.0 || gyration <= kLargestGyration * length) return;
  refuse(body.place,
         fmt::format("{} of {:.4g} kg has {:.4g} kg m^2, a radius of gyration "
                     "of {:.4g} m, where the mechanism's links have {:.4g} m "
                     "at most",
                     name, m.mass, largest, gyration, length));
}

}  // namespace

void require_plausible(const MechanismDefinition& mechanism) {
  for (const JointDefinition& joint : mechanism.joints) {
    const std::string name = "joint \"" + joint.name + "\"";
    require_length(joint.frame_a.p_LJ, joint.place, name);
    require_length(joint.frame_b.p_LJ, joint.place, name);
    if (std::abs(joint.lead) > kLargestLead) {
      refuse(joint.place, fmt::format("{} slides {:.3g} m per turn, as no "
                                      "screw does",
                                      name, joint.lead));
    }
  }
  const double length = link_length(mechanism);
  for (const BodyDefinition& body : mechanism.bodies) {
    require_plausible(body, length);
  }
}

}  // namespace clevis::scene
