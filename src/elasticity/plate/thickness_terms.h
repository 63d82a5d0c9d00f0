#pragma once

#include <Eigen/Core>

namespace clevis::elasticity {

/// Which of a plate's fields are even functions of the height over its
/// mid-plane: loads of either kind leave the other's displacements at zero.
enum class Parity {
  kStretching,  ///< u_x, u_y even, u_z odd: loads symmetric about the mid-plane
  kBending,     ///< u_x, u_y odd, u_z even
};

/// Order of term a of a field: 2a if even, 2a + 1 if odd.
int in_plane_order(Parity parity, int term);
int transverse_order(Parity parity, int term);

/// Legendre polynomials P_k(2z/t): orders × points, z/t + ½ in [0, 1].
Eigen::MatrixXd legendre_table(int highest, const Eigen::VectorXd& points);

/// Integrals through the thickness of products of the `terms` Legendre
/// polynomials P(2z/t) of the in-plane and of the transverse field.
struct ThicknessIntegrals {
  Eigen::MatrixXd in_plane;           ///< ∫ P P dz [m]
  Eigen::MatrixXd in_plane_slopes;    ///< ∫ P' P' dz [1/m]
  Eigen::MatrixXd transverse;         ///< [m]
  Eigen::MatrixXd transverse_slopes;  ///< [1/m]
  /// In-plane × transverse [1].
  Eigen::MatrixXd value_by_slope, slope_by_value;
};
/// @param thickness  of the plate [m].
ThicknessIntegrals thickness_integrals(Parity parity, int terms,
                                       double thickness);

}  // namespace clevis::elasticity
