#pragma once

#include <vector>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"
#include "part/load_series.h"
#include "part/mass_properties.h"
#include "part/part_definition.h"

namespace clevis::loads {

/// Loads of one `[[part.history]]`, an instant per row of its file.
///
/// Pins become bearing seats, faces seats with a linear traction. Where nothing
/// holds the part its inertia takes up what the loads leave: all of it if the
/// file gives no accelerations, else up to `largest_imbalance` of the largest
/// load of the series. What it took up stands in the notes.
/// @throws Error L001 if more is left, L002, M003.
LoadHistory series_loads(const part::PartDefinition& part,
                         const part::LoadSeries& series,
                         const std::vector<GroupGeometry>& groups,
                         const part::MassProperties& mass);

}  // namespace clevis::loads
