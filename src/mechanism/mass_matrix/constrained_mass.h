#pragma once

#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

#include "mechanism/mass_matrix/tree_mass.h"
#include "numerics/factors/jacobian_factor.h"
#include "numerics/factors/normal_cholesky.h"

namespace clevis::mechanism {

/// Mass matrix M of free bodies with constraint rows J:
///
///     M a = Q + Jᵀ λ,   J a = γ,
///
/// solved by NormalCholesky of W = J M^(−1/2) where its rows are clearly
/// independent, or some clearly depend on the others. Where that is not clear,
/// a complete orthogonal decomposition of J truncated at kRankThreshold splits
/// a into what the rows fix and what the null space leaves to the forces: that
/// depends on the geometry only, not on the masses. Rows beyond the rank are
/// left out: near a change point they would act as constraints with arbitrary
/// multipliers.
///
/// Unknowns are those of ConstraintSystem, all lengths: M [kg], a and γ [m/s²],
/// Q and λ [N], J [1].
class ConstrainedMass {
 public:
  /// @param columns  a multiple of 3.
  /// @param threshold  SolvingFrame::rank_threshold().
  ConstrainedMass(int columns, int most_rows,
                  double threshold = numerics::kRankThreshold);

  /// The k-th 3 × 3 block of F [1/√kg], M^(−1) = F Fᵀ; all others are zero.
  void set_diagonal(int k, const Eigen::Vector3d& diagonal) {
    factors_[static_cast<std::size_t>(k)] = {
        diagonal.asDiagonal(), diagonal.cwiseInverse().asDiagonal(), true};
  }
  /// @param inverse  of the block.
  void set_full(int k, const Eigen::Matrix3d& block,
                const Eigen::Matrix3d& inverse) {
    factors_[static_cast<std::size_t>(k)] = {block, inverse, false};
  }

  /// Where J has the rows of a tree alone they need no more than that.
  /// @param links  of tree_links(), may be empty.
  void set_tree(std::vector<TreeLink> links, int width);
  TreeMass* tree() { return tree_ ? &*tree_ : nullptr; }
  /// `part` F of the columns of a body.
  void apply_factor_of_body(int body, double* part) const;
  /// The same as factor() with the rows that stand in the tree, each times F.
  /// @return whether they are clearly independent.
  bool factor_tree();

  /// @param J  its first `rows` rows count.
  void factor(const Eigen::MatrixXd& J, int rows);

  /// a and λ (of the first rows; 0 for those left out).
  void accelerate(const Eigen::VectorXd& gamma, const Eigen::VectorXd& Q,
                  Eigen::VectorXd& a, Eigen::VectorXd& lambda);
  /// The change of least mass norm with J change = −residual; both [m] or
  /// [m/s].
  void correct(const Eigen::VectorXd& residual, Eigen::VectorXd& change);

  /// M v.
  Eigen::MatrixXd mass_times(const Eigen::MatrixXd& v) const;

  int rank() const { return rank_; }
  /// Smallest pivot of W Wᵀ among the rows that count, about (σ_min/σ_max)²:
  /// it vanishes at a change point.
  double smallest_pivot() const { return smallest_pivot_; }
  long orthogonal_factorisations() const { return orthogonal_count_; }

 private:
  void solve_tree(const Eigen::VectorXd& gamma, Eigen::VectorXd& a,
                  Eigen::VectorXd& lambda);
  void fill_rows(const Eigen::MatrixXd& J);
  void orthogonal(const Eigen::MatrixXd& J);
  /// v + N z with Nᵀ (M (v + N z) − forces) = 0, N the null space.
  Eigen::VectorXd completed(const Eigen::VectorXd& v,
                            const Eigen::VectorXd& forces) const;
  void apply_factor(Eigen::VectorXd& v) const;             // v ← F v
  void apply_factor_transposed(Eigen::VectorXd& v) const;  // v ← Fᵀ v

  struct Factor {
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();
    bool diagonal = true;
  };
  double threshold_;
  int columns_, rows_{}, rank_{}, geometric_rank_ = -1;
  double smallest_pivot_ = 1.0;
  bool truncated_ = false;
  bool reduced_ = false;  ///< rows are left out: back at twice the bound
  bool was_reduced_ = false;
  long orthogonal_count_{};
  std::vector<Factor> factors_;
  std::optional<TreeMass> tree_;
  bool on_tree_ = false;  ///< the last factor()
  int width_ = 3;
  numerics::NormalCholesky normal_;
  Eigen::VectorXd scale_, x_, hat_rows_, hat_;
  // of the orthogonal way, which may allocate
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition_;
  Eigen::MatrixXd null_space_;
  Eigen::LLT<Eigen::MatrixXd> null_mass_;
};

}  // namespace clevis::mechanism
