#pragma once

#include <vector>

#include "assessment/models/level.h"
#include "elasticity/fe_space/discretization.h"
#include "stress/field/stress_history.h"

namespace clevis::assessment {

/// A point of the lattice where the peak may stand.
struct Place {
  double mean{}, high{}, low{};  ///< by the cells that meet there [Pa]
  int number{};                  ///< of MeetingPoints
  stress::FieldPoint at;         ///< in the cell that says most
  int instant{};
};

/// Places of one set, highest first.
struct PlacesOfSet {
  std::vector<Place> places;
  std::vector<std::vector<int>> cells;  ///< per number
};

/// @param least  stress that a place reaches by one of its cells [Pa]; points
///   below zero do not count.
template <int dim>
PlacesOfSet find_places(const elasticity::Discretization<dim>& discretization,
                        const stress::StressHistory& history, double least);

/// Estimate of the peak of the solved fields by the cells that meet: a second
/// opinion, for the peak is by one cell alone [Pa].
struct CellAgreement {
  double mean{};  ///< largest mean
  double jump{};  ///< largest difference where the mean is not far below it
};

/// Errors of cells that meet have opposite signs: each is about half of what
/// they differ by [1].
inline constexpr double kErrorOfJump = 0.5;

/// @param histories  of the level's sets; points below zero do not count.
template <int dim>
CellAgreement cell_agreement(
    const Level<dim>& level,
    const std::vector<stress::StressHistory>& histories);

}  // namespace clevis::assessment
