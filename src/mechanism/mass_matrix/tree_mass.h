#pragma once

#include <vector>

#include <Eigen/Core>

#include "base/values/index.h"
#include "mechanism/constraints/solving_frame.h"

namespace clevis::mechanism {

/// One of the bodies of a tree, the rows that tie it to one nearer the ground.
struct TreeLink {
  int body{};       ///< from 0
  int parent = -1;  ///< or ground
  int joint = -1;   ///< or free
  std::vector<int> rows;
};

/// Links of a tree, each body tied to its parent by one joint and its drives:
/// outer ones first. Empty if couplings or loops tie the bodies otherwise.
/// @param joint_of_row  by row of the constraint system.
std::vector<TreeLink> tree_links(const SolvingFrame& frame,
                                 const std::vector<int>& joint_of_row);

/// M a = Q + Jᵀ λ, J a = γ on a tree, by articulated inertias from the outer
/// bodies inwards ([Featherstone2008] 7) in coordinates in which M = 1; the
/// rows of each joint as they are, also where gaps are open.
class TreeMass {
 public:
  /// @param width  unknowns of a body, 3 or 6.
  TreeMass(std::vector<TreeLink> links, int width);

  int rows() const { return rows_; }
  /// Row `row` of J F: of its body and of its parent's, `width` each.
  double* of_body(int row) { return rows_of_[index(row)].body; }
  double* of_parent(int row) { return rows_of_[index(row)].parent; }
  const std::vector<TreeLink>& links() const { return links_; }

  /// @return false if rows of a joint depend on one another.
  bool factor();
  double smallest_pivot() const { return smallest_pivot_; }
  /// @param forces  Fᵀ Q; becomes F⁻¹ a.
  void solve(const Eigen::VectorXd& gamma, Eigen::VectorXd& forces,
             Eigen::VectorXd& lambda);
  /// Wins back digits of a and λ that small pivots have cost.
  void refine(const Eigen::VectorXd& gamma, Eigen::VectorXd& a,
              Eigen::VectorXd& lambda);

 private:
  static constexpr int kMost = 6;
  struct Row {
    double body[kMost], parent[kMost], scale;
  };
  /// Lower triangles with inverse diagonals.
  struct Link {
    bool is_free = true;  ///< nothing hangs on it: inertia 1
    double inertia[kMost][kMost];
    double body[kMost][kMost];    ///< C L⁻ᵀ by row, L of the inertia
    double joint[kMost][kMost];   ///< K of C L⁻ᵀ L⁻¹ Cᵀ
    double parent[kMost][kMost];  ///< K⁻¹ times rows of the parent
    double left[kMost];           ///< of γ, in solve()
  };

  // for bodies of kWidth unknowns, so that loops over these are unrolled
  template <int kWidth>
  bool factor_links();
  template <int kWidth>
  bool factor_link(std::size_t k);
  template <int kWidth>
  void add_to_parent(std::size_t k);
  template <int kWidth>
  void solve_links(const Eigen::VectorXd& gamma, Eigen::VectorXd& forces,
                   Eigen::VectorXd& lambda);

  std::vector<TreeLink> links_;
  int width_, rows_{};
  double smallest_pivot_ = 1.0;
  std::vector<Row> rows_of_;
  std::vector<Link> work_;  ///< by link
  std::vector<int> link_of_body_;
  Eigen::VectorXd gap_, change_, reaction_;  // of refine()
};

}  // namespace clevis::mechanism
