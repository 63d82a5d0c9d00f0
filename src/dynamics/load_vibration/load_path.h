#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace clevis::dynamics {

/// Coordinates of a quasi-static answer between the instants at which they are
/// known: on each interval the cubic with the slopes of [FritschButland1984],
/// which never leaves the values at its ends. Its slope jumps only at bends
/// that are known, and where the second difference is four times those beside
/// it: at the bend of a ramp. Instants next to one another closer than `jump`
/// are the two sides of an event; there the coordinates jump, and nothing lies
/// between.
class LoadPath {
 public:
  enum class Between {
    kCubic,
    kLinear  ///< as of a table's rows: the slope jumps at each instant
  };
  /// @param time    rising [s]. @param values  coordinates × instants.
  /// @param jump    [s], >= 0.
  /// @param bends   rising; of them those count that are instants, to `jump`
  ///   [s].
  LoadPath(Eigen::VectorXd time, Eigen::MatrixXd values, double jump,
           Between between = Between::kCubic,
           const std::vector<double>& bends = {});

  Eigen::Index size() const { return time_.size(); }
  Eigen::Index coordinates() const { return values_.rows(); }
  const Eigen::VectorXd& time() const { return time_; }
  const Eigen::MatrixXd& values() const { return values_; }

  /// From instant i to the next: value + a1 τ + a2 τ² + a3 τ³, the columns
  /// a1, a2, a3; zero where the coordinates jump.
  Eigen::MatrixXd cubic(Eigen::Index i) const;
  bool is_jump(Eigen::Index i) const;
  /// Whether a bend is known at instant i.
  bool is_bend(Eigen::Index i) const {
    return is_bend_[static_cast<std::size_t>(i)];
  }
  /// At any time; those of the ends before and after them.
  Eigen::VectorXd at(double t) const;
  Between between() const { return between_; }
  /// By how much the slope jumps where interval i begins, or, if the
  /// coordinates jump in it, over it, per second; before the first instant
  /// nothing changes.
  Eigen::VectorXd bend(Eigen::Index i) const;

 private:
  void set_piece(Eigen::Index first, Eigen::Index last);
  void set_slopes(Eigen::Index coordinate, Eigen::Index first,
                  Eigen::Index last);

  Eigen::VectorXd time_;
  Eigen::MatrixXd values_;
  double jump_;
  Between between_;
  std::vector<bool> is_bend_;    ///< by instant
  Eigen::MatrixXd start_, end_;  ///< slopes per interval
};

/// The path without every second instant of each smooth piece of seven or more:
/// its difference estimates the error of interpolation. A table stays whole.
LoadPath thinned(const LoadPath& path);

}  // namespace clevis::dynamics
