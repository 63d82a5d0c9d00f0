#pragma once

#include <string>

#include "loads/history/load_history.h"

namespace clevis::app {

/// Loads of a motion as RFC 4180 text that [[part.history]] reads: a row per
/// instant, in the part's frame; moments about the middle of each seat's bore
/// or the centroid of its face, accelerations minus gravity. Where on a wall a
/// slide presses is not in it.
std::string loads_csv(const loads::LoadHistory& history);

}  // namespace clevis::app
