#pragma once

#include <functional>

#include <Eigen/Core>

namespace clevis::elasticity {

/// Columns of a Cholesky factor, by columns: `own` rows of the lower triangle
/// (above it anything), then `later` rows.
template <typename Real>
struct Panel {
  const Real* value;
  int own;
  int later;
  int rows() const { return own + later; }
};
template <typename Real>
struct MutablePanel {
  Real* value;
  int own;
  int later;
  int rows() const { return own + later; }
};

template <typename Real>
using MatrixOf = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Rows of a matrix that is stored by columns.
template <typename Real>
using RowBlock = Eigen::Ref<MatrixOf<Real>, 0, Eigen::OuterStride<>>;

/// Calls task(0) … task(tasks − 1), in any order or at the same time.
using ForTasks =
    std::function<void(int tasks, const std::function<void(int)>& task)>;

/// One after the other.
void one_by_one(int tasks, const std::function<void(int)>& task);

/// Factors the panel in place and subtracts what it takes from the later rows.
/// Large ones are worked on in blocks, which are tasks: the same bits whoever
/// runs them.
/// @param border  later × later, by columns, in the units of the matrix; its
///   lower triangle is updated.
/// @return false if the own rows are not positive definite.
template <typename Real>
bool eliminate(MutablePanel<Real> panel, Real* border, const ForTasks& run);

/// own ← L₁⁻¹ own, border ← L₂ own, with the matrices L₁ of the panel's own and
/// L₂ of its later rows.
template <typename Real>
void forward(Panel<Real> panel, RowBlock<Real> own, MatrixOf<Real>& border);

/// own ← L₁⁻ᵀ (own − L₂ᵀ border), with the same matrices.
template <typename Real>
void backward(Panel<Real> panel, const MatrixOf<Real>& border,
              RowBlock<Real> own);

}  // namespace clevis::elasticity
