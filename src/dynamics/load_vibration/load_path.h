#pragma once

#include <Eigen/Core>

namespace clevis::dynamics {

/// Coordinates of a quasi-static answer between the instants at which they are
/// known: on each interval the cubic with the slopes of [FritschButland1984],
/// which never leaves the values at its ends and whose slope has no jump.
/// Instants next to one another closer than `jump` are the two sides of an
/// event; there the coordinates jump, and nothing lies between.
class LoadPath {
 public:
  /// @param time    rising [s]. @param values  coordinates × instants.
  /// @param jump    [s], >= 0.
  LoadPath(Eigen::VectorXd time, Eigen::MatrixXd values, double jump);

  Eigen::Index size() const { return time_.size(); }
  Eigen::Index coordinates() const { return values_.rows(); }
  const Eigen::VectorXd& time() const { return time_; }
  const Eigen::MatrixXd& values() const { return values_; }

  /// From instant i to the next: value + a1 τ + a2 τ² + a3 τ³, the columns
  /// a1, a2, a3; zero where the coordinates jump.
  Eigen::MatrixXd cubic(Eigen::Index i) const;
  bool is_jump(Eigen::Index i) const;
  /// Slope that interval i has at its end, per second.
  Eigen::VectorXd end_slope(Eigen::Index i) const { return end_.col(i); }

 private:
  void set_piece(Eigen::Index first, Eigen::Index last);

  Eigen::VectorXd time_;
  Eigen::MatrixXd values_;
  double jump_;
  Eigen::MatrixXd start_, end_;  ///< slopes per interval
};

/// The path without every second instant of each smooth piece: its difference
/// estimates the error of interpolation.
LoadPath thinned(const LoadPath& path);

}  // namespace clevis::dynamics
