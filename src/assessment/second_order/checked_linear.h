#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "assessment/second_order/second_order_loads.h"

namespace clevis::assessment {

/// An instant, or a place between two, by linear theory.
struct LinearPoint {
  double here{}, peak{};       ///< by this degree, and by the check's [Pa]
  double moved{}, deflects{};  ///< likewise [m]
  /// Whether the check's are known, not guessed.
  bool is_peak_known = false, is_deflection_known = false;

  /// The share of the way from this point to another, whose ratios of degrees
  /// are the larger of both.
  LinearPoint between(const LinearPoint& other, double stress,
                      double displacement) const;
};

/// What the check found by linear theory, of a load set.
class CheckedLinear {
 public:
  /// @param result, rows  of the check at rest; `result` outlives the object.
  /// @param swing  of the set's motion, which is in the result's deflection.
  CheckedLinear(const PartResult& result, const std::vector<InstantRow>& rows,
                std::size_t set, const Swing& swing);

  /// Whether its values refer to an instant.
  bool refers_to(const std::string& label, double time) const;
  /// @param stress, displacement  of each point by this degree [Pa], [m].
  std::vector<LinearPoint> of(const std::vector<LoadPoint>& points,
                              const Eigen::VectorXd& stress,
                              const Eigen::VectorXd& displacement) const;

 private:
  bool is_judged(const std::string& label, double time) const;
  bool deflects_most(const std::string& label, double time) const;

  const PartResult& result_;
  std::size_t set_;
  Swing swing_;
  std::map<std::pair<std::string, double>, double> peaks_;
};

}  // namespace clevis::assessment
