#pragma once

#include <limits>
#include <optional>

namespace clevis::mechanism {

/// Processor time that a motion may take, and what an integration is forecast
/// to.
/// Times in seconds of the processor, but t in seconds of the motion.
class TimeLimit {
 public:
  /// Of this thread [s].
  static double processor_time();

  /// Starts now. @param limit  [s]. @param passes  over the motion, all alike.
  TimeLimit(double limit, double duration, int passes,
            double (*clock)() = processor_time);

  /// The pass at hand has ended.
  void end_pass();
  /// Whether the integration is to stop at t: what it has used is above the
  /// limit, or its forecast is, so far that no error of the forecast matters.
  bool is_over(double t);
  /// Whether it is used up: without a forecast, for work that goes to and fro
  /// in t.
  bool is_used_up() const { return used() > limit_; }
  double used() const { return clock_() - start_; }  ///< [s]
  /// Of all passes, that which the one at hand has reached at t [1].
  double share(double t) const;
  /// Of the whole, as of the last is_over() [s].
  double forecast() const { return forecast_; }
  double limit() const { return limit_; }  ///< [s]
  /// A limit that the whole should keep, in round figures: three times
  /// the forecast. None if that is so far above the limit that no one means
  /// it [s].
  std::optional<double> enough() const;

 private:
  double (*clock_)();
  double limit_, duration_, start_, pass_start_;
  int passes_, passes_left_;
  /// A time and where the motion stood then: the forecast goes by the progress
  /// since, for a start may be slow.
  struct Mark {
    double used{}, t{};
  };
  Mark earlier_, later_;
  double forecast_ = std::numeric_limits<double>::infinity();
};

}  // namespace clevis::mechanism
