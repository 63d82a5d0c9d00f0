#pragma once

#include "report/figures/plot.h"
#include "report/variants/collection.h"

namespace clevis::report {

/// Peak stress with its band against each setting that varies,
/// a row of panels for each part, the limit dashed. Settings that are no
/// numbers stand in the order of their first variant.
PlotFigure collection_figure(const Collection& collection);

}  // namespace clevis::report
