#pragma once

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/plate/thickness_terms.h"

namespace clevis::elasticity {

/// One layer of hexahedra over a plate's mid-plane, quads of degree p by
/// `thickness_degree` through the thickness: node (q + 1) i + k stands above
/// the plane's node i at the k-th Gauss–Lobatto height from below. Groups are
/// the plate's sides, under the plane's names and numbers.
/// @pre the plane's cells are quads.
Discretization<3> layer_over(const Discretization<2>& plane,
                             int thickness_degree);

/// Displacements of a plate as terms of Legendre polynomials through the
/// thickness: unknown (3 n) i + n c + a is component c of term a at the
/// plane's node i.
class ThicknessReduction {
 public:
  /// @param terms  n of each field; the layer's degree is 2n − 1.
  ThicknessReduction(Parity parity, int terms);

  /// T: terms [m] to the layer's nodal displacements [m], column by column.
  Eigen::MatrixXd expand(const Eigen::MatrixXd& terms) const;
  /// Tᵀ: the layer's nodal loads [N] to loads of the terms [N].
  Eigen::MatrixXd reduce(const Eigen::MatrixXd& nodal) const;

  /// Rigid motions of the parity as terms [m] per metre or radian: along x and
  /// y and about z, or along z and about x and y.
  /// @param positions  of the plane's nodes [m].
  /// @param thickness  of the plate [m].
  Eigen::MatrixXd rigid_modes(const Eigen::Matrix2Xd& positions,
                              double thickness) const;

  Parity parity() const { return parity_; }
  int terms() const { return terms_; }

 private:
  Parity parity_;
  int terms_;
  Eigen::MatrixXd in_plane_, transverse_;  ///< heights × terms
};

}  // namespace clevis::elasticity
