#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "assessment/buckling/buckling_model.h"
#include "assessment/job/part_job.h"
#include "assessment/second_order/checked_linear.h"
#include "assessment/second_order/second_order_loads.h"
#include "elasticity/buckling/stressed_part.h"

namespace clevis::assessment {

/// What the part yields to a load at most, over linear theory's [1].
/// @param yield  1/λ + (Ω/ω)² of buckling and whirling.
double rise_at_most(double yield);

/// A load set by linear theory, from which second order starts.
class LinearSet {
 public:
  using Measured = std::pair<Eigen::VectorXd, Eigen::VectorXd>;

  /// All but `rows` outlive the object.
  /// @param space  of the model's lowest degree.
  LinearSet(const PartJob& job, const PartSpace& space,
            const SecondOrderLoads& looked, const std::vector<InstantRow>& rows,
            const PartResult& result);

  /// Of the set's loads.
  void take_points(const elasticity::StressedPart& part);
  const std::vector<LoadPoint>& points() const { return points_; }
  /// What is spun alone, of a part that turns on.
  const std::optional<Eigen::VectorXd>& common() const { return common_; }
  /// Whether all that rises of a point is what the motion's loads have in
  /// common.
  bool is_spun_in_part(const LoadPoint& point) const;

  /// Share of buckling's load that presses, 1/λ; 0: first order is enough.
  double pressed() const { return looked_.pressed; }
  /// 1/λ + (Ω/ω)² at most; 0: first order is enough.
  /// @param lowest  frequency of the held part [rad/s].
  double yield(const LoadPoint& point, double lowest) const;
  /// Whether no spin of the instants counts beside a frequency [rad/s].
  bool is_slow(double frequency) const;
  Swing swing(const LoadPoint& point) const {
    return point.is_motion ? swing_ : Swing{};  // cases stand still
  }

  /// Largest stress [Pa] outside of zones and displacement [m] by instant.
  /// @param columns  displacements, dofs × columns [m].
  Measured measured(const Eigen::MatrixXd& columns,
                    const Eigen::MatrixXd& amounts) const;
  std::vector<LinearPoint> linear(const std::vector<LoadPoint>& points,
                                  const Measured& here) const;
  /// Whether stresses were seen if there are any.
  bool is_seen(const Measured& here) const;

 private:
  const PartJob& job_;
  const PartSpace& space_;
  const SecondOrderLoads& looked_;
  const PeakStress& judged_;
  Swing swing_;
  Eigen::MatrixXi zone_of_;
  CheckedLinear checked_;
  std::vector<LoadPoint> points_;
  std::optional<Eigen::VectorXd> common_;
};

/// Points of a load set with one hold of the part, by linear theory.
class HeldPoints {
 public:
  /// @param set, part  outlive the object.
  /// @param lowest  frequency [rad/s].
  HeldPoints(const LinearSet& set, const elasticity::StressedPart& part,
             const elasticity::HeldPart& held, std::size_t hold, double lowest);

  std::size_t hold() const { return hold_; }
  std::size_t size() const { return points_.size(); }
  const LoadPoint& point(std::size_t i) const { return points_[i]; }
  const LinearPoint& linear(std::size_t i) const { return linear_[i]; }
  /// Whether it is the first hold of a point.
  bool is_first_hold(std::size_t i) const { return is_first_hold_[i]; }
  /// 1/λ + (Ω/ω)² at most; 0: first order is enough.
  double yield(std::size_t i) const { return yields_[i]; }
  /// Stress of the points was seen, or there is none.
  bool is_seen() const { return is_seen_; }

  /// What a point reaches at most [Pa] or [m].
  /// @param yield  1/λ + (Ω/ω)².
  double at_most(std::size_t i, bool by_stress, double yield) const;
  double at_most(std::size_t i, bool by_stress) const {
    return at_most(i, by_stress, yields_[i]);
  }
  /// All of them, by stress [Pa].
  double most() const;
  /// All of them, those first that may rise to most.
  std::vector<std::size_t> by_most(bool by_stress) const;
  /// Between a point and the next.
  LinearPoint linear_between(std::size_t from, const LoadPoint& between) const;

 private:
  void take_points(const elasticity::HeldPart& held);

  const LinearSet& set_;
  const elasticity::StressedPart& part_;
  std::size_t hold_;
  std::vector<LoadPoint> points_;
  std::vector<bool> is_first_hold_;
  std::vector<LinearPoint> linear_;
  std::vector<double> yields_;
  bool is_seen_ = false;
  /// Of what is spun alone [Pa], [m].
  double common_peak_{}, common_deflection_{};
};

}  // namespace clevis::assessment
