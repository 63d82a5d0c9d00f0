#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figures/plot.h"

namespace clevis::app {

/// A figure and the name of its files.
struct NamedFigure {
  std::string name;  ///< is_file_name()
  report::PlotFigure figure;
};

/// Writes NAME.gp, a script with its data, and has gnuplot draw NAME.svg of it,
/// as a child in a folder of its own. Where gnuplot is missing or fails the
/// script remains, an older NAME.svg goes, and stderr says what draws it.
/// @throws Error I002.
void draw_figures(const std::vector<NamedFigure>& figures,
                  const std::filesystem::path& folder);

}  // namespace clevis::app
