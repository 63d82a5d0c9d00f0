#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace clevis::mechanism {

/// A Jacobian that changes with time: fills J, rows × columns, at t.
using TimedJacobian = std::function<void(double t, Eigen::MatrixXd& J)>;

/// Gram and Schmidt's vectors r_i of the rows at one time, in a fixed order.
/// Where the rows lose rank one of them passes zero, and its direction turns
/// round.
struct RowDirections {
  double t{};
  Eigen::MatrixXd directions;  ///< columns: of r_i
  Eigen::VectorXd sizes;       ///< of r_i, of rows of length 1
};

/// Selection of rows of a Jacobian, and their directions. Times [s]; sizes are
/// those of rows of length 1 [1].
class RowSelection {
 public:
  /// @param rank  of the rows in general; fewer than `rows` where constraints
  ///   are redundant.
  RowSelection(int rows, int columns, int rank);

  Eigen::Index rank() const { return rank_; }
  bool has_others() const { return J_.rows() > rank_; }
  /// Room for directions.
  RowDirections frame() const;
  void measure(const TimedJacobian& jacobian, double t, RowDirections& frame);
  /// From now on those count that depend the least on one another at t.
  void choose(const TimedJacobian& jacobian, double t);
  /// Smallest size that the best choice of rows would have at t.
  double best_size(const TimedJacobian& jacobian, double t);
  bool loses_rank(const TimedJacobian& jacobian, double t);

 private:
  Eigen::Index rank_;
  Eigen::MatrixXd J_;
  std::vector<Eigen::Index> order_;  ///< rows that count
};

}  // namespace clevis::mechanism
