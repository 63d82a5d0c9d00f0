#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/displacement_basis.h"
#include "part/material.h"

namespace clevis::stress {

/// What a support does to a part at its plane face, per instant.
struct HeldFace {
  std::string group;
  /// On the part, about the face's centroid, 3 × instants [N], [N m].
  Eigen::Matrix3Xd force, moment;
  /// Nominal stress of the face as the section of a bar, per instant [Pa].
  Eigen::VectorXd nominal;
};

/// The plane faces that hold a part, each as the section of a bar.
///
/// Force and moment are the nodal reactions K u of the held components: exact
/// for what the elements are in balance with, however coarse they are and
/// whatever the edge does to the stress. The inertia of the cells at the face
/// is left out, (ω h / c)² of it in waves of frequency ω. The nominal stress is
/// the largest von Mises of two states: at the nodes N / A + M y / I about both
/// axes with the torsion M_n r / I_p, and the means N / A, V / A. It says
/// nothing of corners, and is beam theory's where the part is a bar there.
/// @param fixed  components held at zero per group. Groups that are not one
///   plane are left out.
template <int dim>
std::vector<HeldFace> held_faces(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material,
    const std::map<std::string, std::array<bool, 3>>& fixed);

}  // namespace clevis::stress
