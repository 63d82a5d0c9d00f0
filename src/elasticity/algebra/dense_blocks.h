#pragma once

#include <Eigen/Core>

namespace clevis::elasticity {

/// Columns of a Cholesky factor, by columns: `own` rows of the lower triangle
/// (above it anything), then `later` rows.
struct Panel {
  const double* value;
  int own;
  int later;
  int rows() const { return own + later; }
};
struct MutablePanel {
  double* value;
  int own;
  int later;
  int rows() const { return own + later; }
};

/// Rows of a matrix that is stored by columns.
using RowBlock = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// Factors the panel in place and subtracts what it takes from the later rows.
/// @param border  later × later, by columns, in the units of the matrix; its
///   lower triangle is updated.
/// @return false if the own rows are not positive definite.
bool eliminate(MutablePanel panel, double* border);

/// own ← L₁⁻¹ own, border ← L₂ own, with the matrices L₁ of the panel's own and
/// L₂ of its later rows.
void forward(Panel panel, RowBlock own, Eigen::MatrixXd& border);

/// own ← L₁⁻ᵀ (own − L₂ᵀ border), with the same matrices.
void backward(Panel panel, const Eigen::MatrixXd& border, RowBlock own);

}  // namespace clevis::elasticity
