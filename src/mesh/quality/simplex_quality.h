#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "mesh/basis/simplex_basis.h"
#include "mesh/quality/cell_quality.h"

namespace clevis::mesh {

/// Bounds of the Jacobian determinant over the whole of curved tetrahedra.
///
/// For a mapping of degree k the determinant is a polynomial of degree
/// 3(k − 1): its Bernstein coefficients bound it, between the nodes too
/// ([Johnen2013]). Where the bound does not decide, the tetrahedron is split
/// into eight and bounded again.
class SimplexQuality {
 public:
  explicit SimplexQuality(int degree);

  /// The smallest determinant is a lower bound if it is positive; if it is
  /// not, the cell folds, or could not be proved not to.
  /// @param cell_points  3 × nodes [m].
  CellQuality of(const Eigen::Matrix3Xd& cell_points) const;

 private:
  double lower_bound(const Eigen::VectorXd& coefficients, int splits) const;

  int degree_;
  SimplexPoints<3> nodes_;
  SimplexTable<3> at_nodes_;            ///< mapping, at the determinant's nodes
  Eigen::MatrixXd to_bernstein_;        ///< of the determinant's values there
  std::vector<Eigen::MatrixXd> split_;  ///< coefficients on each eighth
};

}  // namespace clevis::mesh
