#include "scene/element_base/read_contact_law.h"

namespace clevis::scene {

using mechanism::ContactLaw;
using mechanism::ContactModel;

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

}  // namespace clevis::scene
