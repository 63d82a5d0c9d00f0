#pragma once

#include <vector>

#include "loads/history/load_history.h"

namespace clevis::beam {

/// A history in pieces through which each slide stands at about one place of
/// its wall: its seat stands there, with the wrenches about that point, for a
/// beam is bent where the counterpart touches, not at the middle of the wall.
/// What a piece's slides travel is a sixteenth of the longest way at most.
/// Without slides the history as it is.
std::vector<loads::LoadHistory> at_slide_positions(
    const loads::LoadHistory& history);

}  // namespace clevis::beam
