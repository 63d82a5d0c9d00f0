#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"

namespace clevis::stress {

/// A lattice point of a cell.
struct FieldPoint {
  int cell{};
  int point{};  ///< in elasticity::lattice order
};

/// Von Mises stress of the whole history on the lattice points of all cells,
/// corners, edges and faces included; not averaged between cells.
struct StressHistory {
  int subdivisions{};
  Eigen::MatrixXd worst;          ///< over the instants, points × cells [Pa]
  Eigen::MatrixXi worst_instant;  ///< index, points × cells
  /// Over the points, per instant [Pa]; of many instants to the seven digits of
  /// floats, the largest to the last.
  Eigen::VectorXd peak;
  FieldPoint peak_at;  ///< of the largest peak
  /// How much a peak between the lattice points may be higher: a third of
  /// what the peak gains from every second point to all, and what floats are
  /// off [Pa].
  double sampling_error{};
  int peak_instant{};

  /// Largest peak of all instants [Pa].
  double largest() const { return peak[peak_instant]; }
};

/// How much a peak between the instants may be higher [Pa]: twice the rise of
/// the parabola through the largest and its neighbours, at least a third of
/// what the largest gains from every second instant to all (ends counted);
/// with fewer than twelve instants their whole spread.
/// @param peak  over the points, per instant of one motion [Pa].
double time_sampling_error(const Eigen::VectorXd& peak);

/// @param subdivisions  of each cell's lattice; more see the peak closer.
template <int dim>
StressHistory stress_history(const elasticity::DisplacementBasis<dim>& basis,
                             const part::Material& material, int subdivisions);

/// Largest von Mises of each instant outside of all zones [Pa].
/// @param zone_of  of zone_of_points: points × cells, −1 outside.
template <int dim>
Eigen::VectorXd peaks_outside(const elasticity::DisplacementBasis<dim>& basis,
                              const part::Material& material, int subdivisions,
                              const Eigen::MatrixXi& zone_of);

/// Displacement and stress at the lattice points of all cells at one instant.
struct InstantField {
  int subdivisions{};
  /// Per cell, points × 3: positions in L [m], displacement [m].
  std::vector<Eigen::MatrixXd> points, displacement;
  /// Per cell, points × 6: xx, yy, zz, xy, yz, xz [Pa].
  std::vector<Eigen::MatrixXd> stress;
};
template <int dim>
InstantField instant_field(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material, int subdivisions,
                           int instant);

/// Von Mises stress of rows xx, yy, zz, xy, yz, xz [Pa].
Eigen::VectorXd von_mises(const Eigen::MatrixXd& stress);

/// Stress tensor of a row xx, yy, zz, xy, yz, xz [Pa].
Eigen::Matrix3d stress_tensor(const Eigen::Matrix<double, 1, 6>& row);

/// Position of a lattice point in L [m]; the mid-plane's z for dim = 2.
template <int dim>
Eigen::Vector3d position(const elasticity::Discretization<dim>& discretization,
                         FieldPoint at, int subdivisions);

/// Name of the group whose face the point lies on, else "body".
template <int dim>
std::string surface_group(const elasticity::Discretization<dim>& discretization,
                          FieldPoint at, int subdivisions);

}  // namespace clevis::stress
