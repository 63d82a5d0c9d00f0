#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"

namespace clevis::calculix {

/// The nodes of a discretisation of degree 2 that CalculiX's elements have,
/// numbered anew, and how the others (face and cell centres of hexahedra)
/// follow from them by the serendipity functions. Tetrahedra keep all.
class NodeReduction {
 public:
  explicit NodeReduction(const elasticity::Discretization<3>& discretization);

  int count() const { return count_; }
  /// New number of a node, -1 if it is dropped.
  int number(int node) const { return number_[static_cast<std::size_t>(node)]; }
  /// Local functions at the nodes of an element, in CalculiX's order.
  const std::vector<std::size_t>& functions() const { return functions_; }

  /// The nodes of the elements that a node moves with, by their new numbers,
  /// and their shares; of one of theirs itself.
  std::vector<std::pair<int, double>> followed_by(int node) const;

  /// Tᵀ f: what the dropped nodes carry goes to those that they follow.
  /// @param full  loads, 3 × nodes of the discretisation rows [N].
  Eigen::MatrixXd reduce(const Eigen::MatrixXd& full) const;

 private:
  struct Follower {
    Eigen::Index node;
    int to;
    double weight;
  };
  void follow_in(const std::vector<int>& cell_nodes,
                 std::vector<bool>& is_done);

  std::vector<int> number_;
  int count_ = 0;
  std::vector<std::size_t> functions_;
  /// Local functions in lexicographic order, and the local functions of
  /// gmsh's 20 nodes; hexahedra only.
  std::vector<std::size_t> lexicographic_, serendipity_;
  std::vector<Follower> followers_;
};

}  // namespace clevis::calculix
