#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"
#include "stress/field/stress_history.h"
#include "stress/zones/singular_zone.h"

namespace clevis::stress {

/// Zone in which each lattice point lies (the first one that is near enough),
/// −1 outside all: points × cells.
template <int dim>
Eigen::MatrixXi zone_of_points(
    const elasticity::Discretization<dim>& discretization, int subdivisions,
    const std::vector<SingularZone>& zones);

/// A lattice point outside of a zone whose neighbour along the lattice lies in
/// it.
struct PointBeside {
  FieldPoint at;
  int inside{};  ///< the neighbour, in the same cell
  int zone{};
  double away{}, inside_away{};  ///< their distances over the radius [1]
  /// At most as towards the corner stress rises from there to the zone's
  /// border: (distance / radius)^(1 − λ), of a logarithm its root [1].
  double growth{};
};

/// All of them, cell by cell.
template <int dim>
std::vector<PointBeside> points_beside(
    const elasticity::Discretization<dim>& discretization, int subdivisions,
    const std::vector<SingularZone>& zones);

/// Largest von Mises over a part of the lattice and all instants.
struct PartialPeak {
  double value{};  ///< [Pa]; 0 if no point counts
  FieldPoint at;
  int instant{};
  double sampling_error{};  ///< as in StressHistory, of these points [Pa]
};

/// By how much stress at the border of a zone that is left out exceeds a peak
/// outside of all such zones, where no lattice point stands on it: by a power
/// of the distance through the points on both sides, no steeper than the
/// corner's [Pa].
double excess_at_borders(const StressHistory& history,
                         const Eigen::MatrixXi& zone_of,
                         const std::vector<PointBeside>& beside,
                         const std::vector<bool>& left_out, double peak);

/// @param zone_of  of zone_of_points.
/// @param left_out  per zone.
PartialPeak peak_outside(const StressHistory& history,
                         const Eigen::MatrixXi& zone_of,
                         const std::vector<bool>& left_out, int dim);

/// Largest von Mises of each zone over all instants [Pa].
std::vector<double> peaks_inside(const StressHistory& history,
                                 const Eigen::MatrixXi& zone_of,
                                 std::size_t zones);

/// Von Mises at a lattice point for every instant [Pa].
template <int dim>
Eigen::VectorXd point_history(const elasticity::DisplacementBasis<dim>& basis,
                              const part::Material& material, FieldPoint at,
                              int subdivisions);

}  // namespace clevis::stress
