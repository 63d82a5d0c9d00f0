#include "scene/line_elements/read_friction.h"

#include "mechanism/joints/joint_types.h"
#include "scene/motion/read_bodies.h"

namespace clevis::scene {
namespace {

using mechanism::FrictionLaw;
using mechanism::FrictionModel;

/// Of a slide's own joint.
mechanism::Guide read_guide(const mechanism::JointDefinition& joint,
                            StrictTable guide, const Names& names) {
  const Value name = guide["body"];
  const auto body = find_body_or_ground(name, names);
  if (body != joint.body_a && body != joint.body_b) {
    throw name.refusal("S010", "is not joined by joint " + joint.name,
                       "Name the body that has the guide.");
  }
  return {.length = guide["length"].positive(Dimension::kLength),
          .is_on_b = body == joint.body_b};
}

/// Friction that follows the force of its joint: coefficients, and where the
/// joint turns the radius of the pin, else its guide if that is known.
void read_following(const LineSource& source, FrictionLaw& law) {
  StrictTable& table = source.table;
  const Value kinetic = table["kinetic_friction"];
  law.follows_reaction = true;
  law.kinetic = kinetic.number(0.0, 100.0);
  const auto at_rest = table.find("static_friction");
  law.breakaway = at_rest ? at_rest->number(0.0, 100.0) : law.kinetic;
  if (law.kinetic > law.breakaway) {
    throw kinetic.refusal("S006", "is above the static friction",
                          "Friction at rest is at least that in motion.");
  }
  const mechanism::JointDefinition* joint = source.joint();
  if (joint == nullptr ||
      !mechanism::traits(joint->type).takes_reaction_friction) {
    throw kinetic.refusal("S010", "follows the force of no such joint",
                          "Name a revolute, prismatic or cylindrical joint.");
  }
  if (law.model == FrictionModel::kLuGre) {
    throw kinetic.refusal("S010", "is not for bristles",
                          "Choose the model \"coulomb\" or \"regularized\".");
  }
  if (!source.is_angle()) {
    if (table.has("guide")) {
      law.guide = read_guide(*joint, table.table("guide"), source.names);
    }
    return;
  }
  const double radius = table["pin_radius"].positive(Dimension::kLength);
  law.kinetic *= radius;
  law.breakaway *= radius;
}

void read_given_friction(StrictTable& table, const LineUnits& units,
                         FrictionLaw& law) {
  const Value breakaway = table["breakaway"];
  law.breakaway = not_negative(breakaway, units.effort);
  law.kinetic = not_negative(table["kinetic"], units.effort);
  if (law.kinetic > law.breakaway) {
    throw breakaway.refusal("S006", "is below the kinetic friction",
                            "Friction at rest is at least that in motion.");
  }
  if (law.model == FrictionModel::kLuGre && !(law.kinetic > 0.0)) {
    throw breakaway.refusal("S006", "with kinetic = 0 has no bristles",
                            "Give a kinetic friction above zero.");
  }
}

}  // namespace

mechanism::LineLaw read_friction(const LineSource& source) {
  StrictTable& table = source.table;
  const LineUnits units = source.units();
  FrictionLaw law;
  if (const auto model = table.find("model")) {
    law.model = model->choice<FrictionModel>(
        {{"coulomb", FrictionModel::kCoulomb},
         {"regularized", FrictionModel::kRegularized},
         {"lugre", FrictionModel::kLuGre}});
  }
  if (table.has("kinetic_friction")) {
    read_following(source, law);
  } else {
    read_given_friction(table, units, law);
  }
  law.viscous = not_negative_or(table, "viscous", units.damping, 0.0);
  law.stribeck_speed =
      not_negative_or(table, "stribeck_speed", units.rate, 0.0);
  if (law.model == FrictionModel::kRegularized) {
    law.regularizing_speed = table["regularizing_speed"].positive(units.rate);
  } else if (law.model == FrictionModel::kLuGre) {
    law.bristle_stiffness =
        plausible_stiffness(table["bristle_stiffness"], units.stiffness);
    law.bristle_damping = not_negative(table["bristle_damping"], units.damping);
  }
  return law;
}

}  // namespace clevis::scene
