#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "part/part_definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// An [[impact]] that is read but for its contact's spring, which needs the
/// part.
struct ImpactOfPart {
  int part{};  ///< index
  StrictTable table;
  part::ImpactDefinition impact{};
};

/// The [[impact]] tables. @throws Error S002–S011.
std::vector<ImpactOfPart> read_impacts(
    StrictTable& root, const mechanism::MechanismDefinition& mechanism,
    Names& names);

/// Gives the part with this index its impacts.
void add_impacts(std::vector<ImpactOfPart>& impacts, int index,
                 part::PartDefinition& part);

}  // namespace clevis::scene
