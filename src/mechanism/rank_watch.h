#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace clevis::mechanism {

/// Finds the times at which rows of a Jacobian that changes with time become
/// dependent.
///
/// Gram and Schmidt's vectors r_i of the rows, in a fixed order, change
/// continuously and one passes zero, so that its direction turns round, where
/// the rows lose rank. An interval is halved until the directions at its ends
/// either agree or are opposite; then Brent's method finds the zero. So neither
/// two losses at once nor a small but steady singular value deceives it.
class RankWatch {
 public:
  /// Fills the Jacobian at time t. @param J  rows × columns.
  using Jacobian = std::function<void(double t, Eigen::MatrixXd& J)>;

  /// @param rank  of the rows in general; fewer than `rows` where constraints
  ///   are redundant.
  /// @param error  of the rows, relative: what is below that may be zero.
  RankWatch(int rows, int columns, int rank, double error = 0.0);

  /// Whether rank is lost at t, within kRankThreshold. The first regular time
  /// begins the watch.
  bool start(const Jacobian& jacobian, double t);

  /// Looks from the last time to t. @return the zeros between, in order.
  /// @param fastest  bound of the change of rows of length 1, about [1/s]:
  ///   what it cannot have made zero is not looked for.
  const std::vector<double>& look(
      const Jacobian& jacobian, double t,
      double fastest = std::numeric_limits<double>::infinity());

 private:
  struct Frame {
    double t{};
    Eigen::MatrixXd directions;  ///< columns: of r_i
    Eigen::VectorXd sizes;       ///< of r_i, of rows of length 1
  };
  void measure(const Jacobian& jacobian, double t, Frame& frame);
  void choose_rows(const Jacobian& jacobian, double t);
  bool regular(const Frame& frame) const;
  /// kReach: the same directions, but a zero and back was within reach.
  enum class Change { kNone, kReach, kFlip, kUnclear };
  Change compare(const Frame& from, const Frame& to, Eigen::Index& flipped,
                 Eigen::Index after) const;
  void find_zeros(const Jacobian& jacobian, const Frame& from, const Frame& to);

  int rank_;
  double zero_;
  bool started_ = false;
  Eigen::MatrixXd J_;
  std::vector<Eigen::Index> order_;  ///< rows that count
  Frame last_, probe_;
  std::vector<Frame> ahead_;  ///< later times, nearest at the back
  std::vector<double> zeros_;
};

}  // namespace clevis::mechanism
