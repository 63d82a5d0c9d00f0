#pragma once

#include "report/figures/plot.h"
#include "study/run.h"

namespace clevis::study {

/// Error of the peak, the energy and the probes against processor seconds
/// (wall-clock time says what else the machine does), degrees of freedom and
/// memory.
report::PlotFigure study_figure(const PartStudy& part);

/// The one plot: error of the peak against processor seconds.
report::PlotFigure peak_against_seconds(const PartStudy& part);

}  // namespace clevis::study
