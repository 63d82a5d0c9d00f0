#include "scene/force_elements/read_contact.h"

#include "scene/element_base/read_contact_law.h"
#include "scene/motion/read_bodies.h"

namespace clevis::scene {

mechanism::ForceElement read_contact(StrictTable& table, const Names& names) {
  mechanism::ContactElement contact;
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

}  // namespace clevis::scene
