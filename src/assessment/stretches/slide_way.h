#pragma once

#include <vector>

#include "loads/history/load_history.h"

namespace clevis::assessment {

/// Where along its wall the counterpart of a slide that holds the part is at
/// each instant of a motion [m]; of the slide whose way is longest. Where the
/// place is not known, that of the instant before. Empty: no such way is longer
/// than `least` [m].
std::vector<double> slide_way(const loads::LoadHistory& motion, double least);

}  // namespace clevis::assessment
