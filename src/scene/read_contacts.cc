#include <array>
#include <vector>

#include <fmt/format.h>

#include "scene/element_readers.h"

namespace clevis::scene {
namespace {

using namespace mechanism;

ContactLaw read_contact_law(StrictTable& table, const LineUnits& units) {
  ContactLaw law;
  law.exponent = 1.0;
  if (const auto model = table.find("model")) {
    law.model = model->choice<ContactModel>(
        {{"penalty", ContactModel::kPenalty},
         {"published", ContactModel::kPublished},
         {"hunt-crossley", ContactModel::kHuntCrossley}});
  }
  law.stiffness = plausible_stiffness(table["stiffness"], units.stiffness);
  if (law.model == ContactModel::kHuntCrossley) {
    law.damping =
        not_negative(table["damping"], units.coordinate == Dimension::kAngle
                                           ? Dimension::kInverseAngularVelocity
                                           : Dimension::kInverseVelocity);
  } else {
    law.damping = not_negative(table["damping"], units.damping);
  }
  if (law.model == ContactModel::kPenalty) {
    law.transition =
        not_negative_or(table, "transition", units.coordinate, 0.0);
  }
  return law;
}

/// Splines through `targets` at `times`, by axis.
std::array<numerics::CubicSpline, 3> read_path(StrictTable& table) {
  if (!table.has("targets")) {
    throw table.refusal("S003", "lacks the key \"target\" or \"targets\"",
                        "Give a point, or times and targets.");
  }
  const std::vector<double> times = increasing_times(table["times"], 2);
  const Value targets = table["targets"];
  std::array<std::vector<double>, 3> points;
  for (const Value& target : targets.elements()) {
    const Eigen::Vector3d p = target.vector(Dimension::kLength);
    for (int k = 0; k < 3; ++k) {
      points[static_cast<std::size_t>(k)].push_back(p[k]);
    }
  }
  if (points[0].size() != times.size()) {
    throw targets.refusal("S010",
                          fmt::format("has {} entries for {} times",
                                      points[0].size(), times.size()),
                          "Give one point per time.");
  }
  const numerics::SplineEnds ends = read_spline_ends(table);
  std::array<numerics::CubicSpline, 3> path;
  for (std::size_t k = 0; k < 3; ++k) {
    path[k] = numerics::interpolating_spline(times, points[k], ends);
  }
  return path;
}

}  // namespace

StopLaw read_stop(StrictTable& table, const LineUnits& units) {
  StopLaw law;
  if (const auto lower = table.find("lower")) {
    law.lower = lower->quantity(units.coordinate);
  }
  if (const auto upper = table.find("upper")) {
    law.upper = upper->quantity(units.coordinate);
    if (law.lower && *law.upper <= *law.lower) {
      throw upper->refusal("S006", "is not above lower",
                           "Leave room between the stops.");
    }
  }
  if (!law.lower && !law.upper) {
    throw table.refusal("S003", "lacks the key \"lower\" or \"upper\"",
                        "Give one or both ends.");
  }
  law.contact = read_contact_law(table, units);
  return law;
}

ContactElement read_contact(StrictTable& table, const Names& names) {
  ContactElement contact;
  const Value body = table["body"];
  contact.center.body = names.bodies.find(body.name(), body);
  contact.center.p_L = table["center"].vector(Dimension::kLength);
  contact.radius = not_negative_or(table, "radius", Dimension::kLength, 0.0);
  if (const auto plane = table.find("plane")) {
    contact.plane.body = find_body_or_ground(*plane, names);
    if (contact.plane.body == contact.center.body) {
      throw plane->refusal("S010", "is the body itself",
                           "Name another body, or \"ground\".");
    }
  }
  contact.plane.p_L = table["plane_point"].vector(Dimension::kLength);
  contact.normal_L = table["normal"].direction();
  contact.law = read_contact_law(table, line_units(false));
  const auto ratio = [&table](std::string_view key, double otherwise) {
    const auto value = table.find(key);
    return value ? value->number(0.0, 100.0) : otherwise;
  };
  contact.static_friction = ratio("static_friction", 0.0);
  contact.kinetic_friction = ratio("kinetic_friction", contact.static_friction);
  if (contact.kinetic_friction > contact.static_friction) {
    throw table["kinetic_friction"].refusal(
        "S006", "is above the static friction",
        "Friction at rest is at least that in motion.");
  }
  if (const auto speed = table.find("critical_speed")) {
    contact.critical_speed = speed->positive(Dimension::kVelocity);
  }
  return contact;
}

ImpedanceElement read_impedance(StrictTable& table, const Names& names) {
  ImpedanceElement impedance;
  const Value body = table["body"];
  impedance.point.body = names.bodies.find(body.name(), body);
  impedance.point.p_L = table["point"].vector(Dimension::kLength);
  if (table.has("target")) {
    impedance.target_W = table["target"].vector(Dimension::kLength);
  } else {
    impedance.path_W = read_path(table);
  }
  impedance.stiffness =
      plausible_stiffness_or_zero(table["stiffness"], Dimension::kStiffness);
  impedance.damping = not_negative(table["damping"], Dimension::kDamping);
  if (const auto of = table.find("damping_of")) {
    impedance.damps_absolute =
        of->choice<bool>({{"relative", false}, {"absolute", true}});
  }
  return impedance;
}

}  // namespace clevis::scene
