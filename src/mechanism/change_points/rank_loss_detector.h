#pragma once

#include <limits>
#include <vector>

#include "mechanism/change_points/near_singular_interval.h"
#include "mechanism/change_points/row_directions.h"

namespace clevis::mechanism {

/// Finds the times [s] at which rows of a Jacobian that changes with time
/// become dependent.
///
/// Gram and Schmidt's vectors r_i of the rows, in a fixed order, change
/// continuously and one passes zero, so that its direction turns round, where
/// the rows lose rank. An interval is halved until the directions at its ends
/// either agree or are opposite. Near a zero, where errors of the Jacobian
/// would decide on a direction, none is compared: those before and behind are,
/// and Brent's method finds where the part of r_i along its direction before
/// vanishes. So neither two losses at once nor a small but steady singular
/// value deceives it, and a zero counts once however near steps end.
class RankLossDetector {
 public:
  /// @param rank  of the rows in general; fewer than `rows` where constraints
  ///   are redundant.
  /// @param error  of the rows, relative: sizes below it say nothing.
  RankLossDetector(int rows, int columns, int rank, double error = 0.0);

  /// Whether rank is lost at t, within kRankThreshold. The first regular time
  /// begins the watch.
  bool start(const TimedJacobian& jacobian, double t);

  /// Looks from the last time to t. @return the zeros that are sure by now, in
  /// order: between the two times, or those it awaited.
  /// @pre the Jacobian is continuous in time from look to look.
  /// @param fastest  bound of the change of rows of length 1, about [1/s]:
  ///   what it cannot have made zero is not looked for.
  const std::vector<double>& look(
      const TimedJacobian& jacobian, double t,
      double fastest = std::numeric_limits<double>::infinity());

  /// Nothing follows: the zeros that are awaited, if the last sign holds.
  const std::vector<double>& finish();

  /// Zeros that are not sure yet.
  const std::vector<double>& awaited() const { return near_singular_.zeros(); }

 private:
  /// Cosine beyond which directions are the same, or opposite.
  static constexpr double kSameDirection = 0.5;

  bool is_clear(const RowDirections& frame) const {
    return rows_.rank() == 0 || frame.sizes.minCoeff() > clear_;
  }
  /// kReach: the same directions, but a zero and back was within reach.
  enum class Change { kNone, kReach, kFlip, kUnclear };
  Change compare(const RowDirections& next) const;
  RowDirections& next() { return ahead_[count_ - 1]; }
  void take_next();
  void follow();
  bool split();
  bool finds_other_rows(double t);
  double along_last(Eigen::Index i, double t);
  double root(Eigen::Index i, double from, double to, double sign);
  bool pass_zeros();
  void await(Eigen::Index i, double from);
  void enter_near_singular();
  void leave_near_singular();
  void confirm_awaited(Eigen::Index i, double apart);
  void note(Eigen::Index i, double zero);

  RowSelection rows_;
  double clear_;
  bool started_ = false;
  const TimedJacobian* jacobian_ = nullptr;  ///< of the look under way
  double from_{};                            ///< its beginning
  int splits_left_{}, choices_left_{};
  RowDirections last_, probe_;
  std::vector<RowDirections> ahead_;    ///< later times, nearest at the back
  std::size_t count_{};                 ///< of these
  NearSingularInterval near_singular_;  ///< since last_
  std::vector<double> zeros_;
  std::vector<Eigen::Index> of_row_;  ///< among those chosen
};

}  // namespace clevis::mechanism
