#include "stress/peaks/local_peak.h"

#include <algorithm>
#include <utility>

#include "stress/peaks/peak_zoom.h"

namespace clevis::stress {

std::vector<int> peak_cells(const StressHistory& history) {
  constexpr double kNear = 0.9;
  constexpr std::size_t kMost = 4;
  std::vector<std::pair<double, int>> highest;
  const double peak = history.largest();
  for (Eigen::Index c = 0; c < history.worst.cols(); ++c) {
    const double value = history.worst.col(c).maxCoeff();
    if (value >= kNear * peak) highest.emplace_back(-value, c);
  }
  std::ranges::sort(highest);
  highest.resize(std::min(highest.size(), kMost));
  std::vector<int> cells;
  for (const auto& entry : highest) cells.push_back(entry.second);
  return cells;
}

template <int dim>
double enriched_peak(const elasticity::Enriched<dim>& enriched,
                     const std::vector<int>& cells,
                     const part::Material& material, int subdivisions) {
  auto history = stress_history<dim>(enriched.basis, material, subdivisions);
  for (std::size_t k = 0; k < enriched.cells.size(); ++k) {
    if (std::ranges::find(cells, enriched.cells[k]) == cells.end()) {
      history.worst.col(static_cast<Eigen::Index>(k)).setZero();
    }
  }
  history.peak[0] = history.worst.maxCoeff();
  return field_maximum<dim>(enriched.basis, material, history);
}

template double enriched_peak<2>(const elasticity::Enriched<2>&,
                                 const std::vector<int>&, const part::Material&,
                                 int);
template double enriched_peak<3>(const elasticity::Enriched<3>&,
                                 const std::vector<int>&, const part::Material&,
                                 int);

}  // namespace clevis::stress
