#include "assessment/places/meeting_places.h"

#include <algorithm>
#include <functional>

#include "stress/peaks/meeting_points.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;

/// Cells whose stress is not far below the peak, and those beside them.
template <int dim>
std::vector<int> stressed_cells(
    const elasticity::Discretization<dim>& discretization,
    const stress::StressHistory& history, double least) {
  std::vector<int> cells;
  for (Index c = 0; c < history.worst.cols(); ++c) {
    if (history.worst.col(c).maxCoeff() >= least) {
      cells.push_back(static_cast<int>(c));
    }
  }
  return elasticity::with_neighbours<dim>(discretization, cells);
}

}  // namespace

template <int dim>
PlacesOfSet find_places(const elasticity::Discretization<dim>& discretization,
                        const stress::StressHistory& history, double least) {
  PlacesOfSet result;
  const auto points = stress::meeting_points<dim>(
      discretization, stressed_cells<dim>(discretization, history, least),
      history.subdivisions);
  const auto n = static_cast<std::size_t>(points.count);
  std::vector<Place> all(n);
  std::vector<double> sum(n, 0.0);
  result.cells.resize(n);
  for (std::size_t k = 0; k < points.cells.size(); ++k) {
    for (Index q = 0; q < points.number.rows(); ++q) {
      const int number = points.number(q, static_cast<Index>(k));
      const auto i = static_cast<std::size_t>(number);
      const int cell = points.cells[k];
      const double value = history.worst(q, cell);
      Place& place = all[i];
      if (result.cells[i].empty()) place.low = value;
      result.cells[i].push_back(cell);
      sum[i] += value;
      place.low = std::min(place.low, value);
      if (value < place.high) continue;
      place.high = value;
      place.number = number;
      place.at = {cell, static_cast<int>(q)};
      place.instant = history.worst_instant(q, cell);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    all[i].mean = sum[i] / static_cast<double>(result.cells[i].size());
    if (all[i].high >= least && all[i].low >= 0.0) {
      result.places.push_back(all[i]);
    }
  }
  std::ranges::stable_sort(result.places, std::greater{}, &Place::high);
  return result;
}

template <int dim>
CellAgreement cell_agreement(
    const Level<dim>& level,
    const std::vector<stress::StressHistory>& histories) {
  constexpr double kShare = 0.6;
  constexpr double kNear = 0.9;
  double largest = 0.0;
  for (const auto& history : histories) {
    largest = std::max(largest, history.worst.maxCoeff());
  }
  std::vector<Place> places;
  CellAgreement result;
  for (std::size_t s = 0; s < histories.size(); ++s) {
    const auto found = find_places<dim>(level.bases[s]->discretization,
                                        histories[s], kShare * largest);
    places.insert(places.end(), found.places.begin(), found.places.end());
  }
  for (const Place& place : places) {
    result.mean = std::max(result.mean, place.mean);
  }
  for (const Place& place : places) {
    if (place.mean < kNear * result.mean) continue;
    result.jump = std::max(result.jump, place.high - place.low);
  }
  return result;
}

#define CLEVIS_INSTANTIATE(dim)                                             \
  template PlacesOfSet find_places<dim>(                                    \
      const elasticity::Discretization<dim>&, const stress::StressHistory&, \
      double);                                                              \
  template CellAgreement cell_agreement<dim>(                               \
      const Level<dim>&, const std::vector<stress::StressHistory>&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::assessment
