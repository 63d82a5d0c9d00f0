#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// Distance between each face of the boundary and the smooth surface that it
/// stands for, its mean over the face [m], from the angles to its neighbours:
/// on a circle a flat face of width h between angles of θ is θ h/12 off, a
/// parabola through three points of it θ h/60. Zero where all edges are those
/// of the part.
/// @return per face of PartMesh::boundary.
std::vector<double> surface_deviation(const mesh::PartMesh<3>& mesh);

/// Share of the strain energy that stands between the faces and the surfaces
/// [1]: what the energy changes by at most, if each face moves onto its
/// surface, Σ δ A w/∫ w dV with w by the square of the stress.
/// @param deviation  of surface_deviation [m].
/// @param stress  von Mises, points × cells [Pa]; a cell has its mean square.
double energy_between(const mesh::PartMesh<3>& mesh,
                      const std::vector<double>& deviation,
                      const Eigen::MatrixXd& stress);

}  // namespace clevis::stress
