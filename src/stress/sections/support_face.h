#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "loads/history/load_history.h"
#include "part/material.h"
#include "part/supports.h"

namespace clevis::stress {

/// What a plane piece of the faces that hold a part passes on into it, per
/// instant: its support's reaction, and loads on the piece itself.
struct SupportFace {
  std::string name;                 ///< of its group, or groups
  std::vector<std::string> groups;  ///< whose faces it has
  /// On the part, about the face's centroid, 3 × instants [N], [N m].
  Eigen::Matrix3Xd force, moment;
  /// Nominal stress of the face as the section of a bar, per instant [Pa].
  Eigen::VectorXd nominal;
};

/// The plane pieces of the faces that hold a part (support_pieces), each as the
/// section of a bar.
///
/// Force and moment are those of the nodes K u − f, f the loads but for those
/// on held faces: of the supports, of an elastic bed and of loads on the same
/// face, exact for what the elements are in balance with, however coarse they
/// are and whatever the edge does to the stress. Of displacements in time the
/// inertia of the cells at the face is left out, (ω h / c)² of it in waves of
/// frequency ω. The nominal stress (nominal_stress) says nothing of corners,
/// and is beam theory's where the part is a bar there.
/// @param fixed    components held at zero per group.
/// @param history  the loads of the basis' instants; of displacements in time
///   without loads.
/// @throws Error of load_columns.
template <int dim>
std::vector<SupportFace> support_faces(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material, const part::Supports& fixed,
    const loads::LoadHistory& history, const std::string& part_name);

}  // namespace clevis::stress
