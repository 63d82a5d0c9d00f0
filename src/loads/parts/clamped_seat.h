#pragma once

#include <vector>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"

namespace clevis::loads {

/// The seat that holds a part alone, of a history of which only loads are
/// known: one that takes a moment, about its own axis if it is a bore, above a
/// tenth of the forces over the part's size, as a weld or the pin of a driven
/// lever does, where no other takes more than friction. Beside fewer than two
/// pins any moment on a face counts, and of a bore that takes loads of a face,
/// too, none is needed. Sets that hold and notes it; else that nothing is
/// known.
/// @param size  of the part [m].
void hold_clamped_seat(const std::vector<GroupGeometry>& groups, double size,
                       LoadHistory& history);

}  // namespace clevis::loads
