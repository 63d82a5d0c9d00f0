#pragma once

#include <optional>
#include <vector>

#include "mechanism/driven_trajectory/driven_trajectory.h"

namespace clevis::mechanism {

/// Finds where the laws of force elements change on a driven motion: zeros of
/// its guards between looks, those that two looks on the same side hide among
/// them.
class DrivenEvents {
 public:
  explicit DrivenEvents(DrivenTrajectory& trajectory);

  /// Looks on both sides of each; both are instants, and the course breaks
  /// there.
  /// @param most  looks. @return whether that, and the halvings between two
  ///   looks, were enough.
  bool find(std::size_t most);
  const std::vector<MotionEvent>& events() const { return events_; }

 private:
  using At = DrivenTrajectory::At;
  struct End {
    double t{};
    Eigen::VectorXd values;
  };
  Eigen::VectorXd bounds(At left) const;
  void search(At left, const End& a, const End& b, const Eigen::VectorXd& bend,
              int depth);
  void roots(At left, const End& a, const End& b);
  std::optional<At> side_at(At left, double t);
  void add_sides(At left, const std::vector<double>& times);
  Eigen::VectorXd values_behind(At left) const;
  void note_changes(At before, At behind, double t);

  DrivenTrajectory& trajectory_;
  Eigen::VectorXd floors_;
  /// In the interval at hand: where loads may jump, and where they bend.
  std::vector<double> found_, bends_;
  std::vector<MotionEvent> events_;
  int halvings_left_{};
  bool missed_ = false;  ///< halvings ran out where events may hide
};

}  // namespace clevis::mechanism
