#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "beam/sections/side_mass.h"
#include "loads/history/load_history.h"
#include "loads/parts/part_loads.h"
#include "mesh/cells/section.h"

namespace clevis::beam {

/// A section of the part with what is needed to evaluate it at every instant.
class Station {
 public:
  /// @param normal  of the section's plane, a unit vector in L.
  /// @param beyond  the material on the side that the normal points at.
  Station(const mesh::Section& section, const Eigen::Vector3d& normal,
          MassMoments beyond);

  const Eigen::Vector3d& centroid() const { return centroid_; }  ///< in L [m]
  const Eigen::Vector3d& normal() const { return normal_; }      ///< in L [1]
  double area() const { return area_; }                          ///< [m²]
  /// Smaller principal second moment [m⁴].
  double smallest_second_moment() const { return smallest_second_moment_; }
  const MassMoments& beyond() const { return beyond_; }

  /// Stress gradient g [Pa/m] that a bending moment [N m] causes,
  /// σ(r) = g · r, r from the centroid: ∫ r × (n g·r) dA = M.
  Eigen::Vector3d bending_gradient(const Eigen::Vector3d& moment) const;

  /// Largest equivalent stress over the extreme fibres [Pa]: axial, bending
  /// and torsion.
  double fibre_stress(const loads::Wrench& section_force) const;

  /// Whether torsion raises that stress by more than 1 %.
  bool is_twisted(const loads::Wrench& section_force) const;

  /// Equivalent stress at the neutral axis [Pa]: axial force, the parabolic
  /// shear 3/2 V/A of a rectangle, torsion.
  double neutral_axis_stress(const loads::Wrench& section_force) const;

 private:
  double normal_stress(const loads::Wrench& section_force) const;
  double torsion_stress(const Eigen::Vector3d& moment) const;

  double area_{}, smallest_second_moment_{}, torsion_modulus_{};
  Eigen::Vector3d centroid_, normal_;
  Eigen::Matrix3d flexibility_;          // g = flexibility (n × M)
  std::vector<Eigen::Vector3d> fibres_;  // from the centroid, convex hull
  MassMoments beyond_;
};

/// Which loads act beyond a plane.
struct LoadsBeyond {
  std::vector<std::size_t> seats, surface_loads;
};

/// Seats by their reference point, surface loads by their group's centroid.
/// @param point  of the plane, in L [m]. @param normal  points beyond it.
LoadsBeyond loads_beyond(const loads::LoadHistory& history,
                         const std::vector<loads::GroupGeometry>& groups,
                         const Eigen::Vector3d& point,
                         const Eigen::Vector3d& normal);

/// Force [N] and moment about the centroid [N m] through a section at an
/// instant: of all loads and inertia beyond it. Tension is a force along the
/// normal.
loads::Wrench section_force(const loads::LoadHistory& history,
                            const loads::InstantLoad& instant,
                            const LoadsBeyond& beyond, const Station& station);

}  // namespace clevis::beam
