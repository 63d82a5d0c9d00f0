#pragma once

#include <vector>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"
#include "part/mass_properties.h"
#include "part/part_definition.h"

namespace clevis::loads {

/// Loads of one `[[part.case]]`: pins become bearing seats, pressure and
/// traction surface loads. A case without `fixed` must be in balance with its
/// inertia.
/// @throws Error L001, L002, M003.
LoadHistory case_loads(const part::PartDefinition& part,
                       const part::LoadCaseDefinition& load_case,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass);

}  // namespace clevis::loads
