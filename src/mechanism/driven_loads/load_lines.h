#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/driven_loads/load_scales.h"

namespace clevis::mechanism {

/// How far the loads of a driven motion lie off the line, or off a curve, from
/// one look to another.
class LoadLines {
 public:
  using At = DrivenTrajectory::At;

  /// The look between two that lies farthest off.
  struct Gap {
    At left, right;
    At worst;             ///< none: the middle, where nothing was looked at yet
    double defect = 0.0;  ///< [1]
    bool operator<(const Gap& other) const { return defect < other.defect; }
  };

  /// @param scales  outlive this.
  explicit LoadLines(const LoadScales& scales)
      : scales_(scales), trajectory_(scales.trajectory()) {}

  /// Off the line, over the scale of its kind; what repeats other loads, and
  /// loads that are small beside the largest, are left out.
  Gap gap(At left, At right) const;
  /// What a cubic through both misses of any load, over what it may.
  Gap curve_gap(At left, At right) const;
  /// Where two looks have none between that could be larger.
  bool is_closed(At left, At right) const;

  /// By load: the greatest part of its largest that any load of its bodies has
  /// at two looks [1].
  Eigen::VectorXd levels(At left, At right) const;
  /// By load: how far off the line between two looks, over its scale [1].
  Eigen::VectorXd off_line(const Eigen::VectorXd& loads, double t, At left,
                           At right) const;
  /// Between neighbours: what the cubic through those about says of the middle.
  std::optional<Eigen::VectorXd> middle_by_cubic(At left, At right) const;

 private:
  Eigen::VectorXd amplitudes(At left, At right) const;
  Gap worst_between(At left, At right,
                    const std::function<double(const Eigen::VectorXd& off,
                                               At look)>& defect_of) const;

  const LoadScales& scales_;
  DrivenTrajectory& trajectory_;
};

}  // namespace clevis::mechanism
