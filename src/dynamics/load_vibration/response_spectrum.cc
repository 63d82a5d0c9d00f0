#include "dynamics/load_vibration/response_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/load_vibration/forced_interval.h"

namespace clevis::dynamics {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

struct Onset {
  double time{}, swing{};
  Index coordinate{};
};

/// Oscillators of one period at a time, one per coordinate.
class Oscillators {
 public:
  /// @param periods  by instant [s].
  Oscillators(const LoadPath& path, const ArrayXd& largest,
              const Eigen::VectorXd& periods, double damping, double least)
      : path_(path),
        scale_((largest > 0.0).select(1.0 / largest, 0.0)),
        damping_(damping),
        least_(least),
        state_{ArrayXd::Zero(largest.size()), ArrayXd::Zero(largest.size())},
        settled_(ArrayXd::Zero(largest.size())),
        most_swing_(settled_),
        reach_(settled_),
        timed_(settled_),
        time_(settled_) {
    for (Index i = 0; i + 1 < path.size(); ++i) {
      period_ = std::sqrt(periods[i] * periods[i + 1]);
      omega_ = 2.0 * std::numbers::pi / period_;
      state_.rate -= path.bend(i).array();
      if (path.is_jump(i)) {
        state_.w -= (path.values().col(i + 1) - path.values().col(i)).array();
      } else {
        swing(i);
      }
      note_onsets(i);
    }
  }

  void add_to(ResponseSpectrum& spectrum) const {
    Index most = 0;
    const double reach = reach_.maxCoeff(&most);
    if (reach > spectrum.amplification) {
      spectrum.amplification = reach;
      spectrum.time = time_[most];
      spectrum.period = period_;
    }
    constexpr double kCounts = 0.3;
    for (const Onset& onset : onsets_) {
      const Index k = onset.coordinate;
      if (reach_[k] > least_ && onset.swing >= kCounts * most_swing_[k]) {
        spectrum.onsets.push_back(onset.time);
      }
    }
  }

 private:
  void look(double t, const ArrayXd& answer) {
    constexpr double kLike = 1.01;  // a swing that goes on tells no time
    for (Index k = 0; k < answer.size(); ++k) {
      reach_[k] = std::max(reach_[k], answer[k]);
      if (answer[k] <= kLike * timed_[k]) continue;
      timed_[k] = answer[k];
      time_[k] = t;
    }
  }

  void swing(Index i) {
    constexpr double kPerPeriod = 16.0, kMost = 40.0;  // periods
    const double from = path_.time()[i], length = path_.time()[i + 1] - from;
    const Eigen::ArrayX3d x = path_.cubic(i);
    const ForcedInterval<double> interval(omega_, damping_, x, state_);
    const ArrayXd start = path_.values().col(i).array();
    const ArrayXd end = path_.values().col(i + 1).array();
    const ArrayXd bound =
        (start.abs().max(end.abs()) + interval.bound(length)) * scale_;
    if ((bound > reach_.max(least_)).any()) {
      const double looked = std::min(length, kMost * period_);
      const auto count =
          static_cast<int>(std::ceil(looked * kPerPeriod / period_));
      for (int j = 0; j <= count; ++j) {
        const double t = looked * j / count;
        const ArrayXd still =
            start + t * (x.col(0) + t * (x.col(1) + t * x.col(2)));
        look(from + t, (still + interval.at(t).w).abs() * scale_);
      }
      if (looked < length) {
        const ForcedInterval<double> rest(
            omega_, damping_, Eigen::ArrayX3d::Zero(x.rows(), 3),
            {interval.at(looked).w, interval.at(looked).rate});
        look(from + looked,
             (start.abs().max(end.abs()) + rest.bound(0.0)) * scale_);
      }
    }
    state_ = interval.at(length);
  }

  void note_onsets(Index i) {
    constexpr double kGrows = 1.1, kNothing = 0.01, kCounts = 0.3;
    const ArrayXd now =
        (state_.w.square() + (state_.rate / omega_).square()).sqrt() * scale_;
    for (Index k = 0; k < now.size(); ++k) {
      most_swing_[k] = std::max(most_swing_[k], now[k]);
      if (now[k] > kNothing && now[k] > kGrows * settled_[k]) {
        if (now[k] > kCounts * most_swing_[k]) {
          onsets_.push_back({path_.time()[i], now[k], k});
        }
        settled_[k] = now[k];
      } else {
        settled_[k] = std::min(settled_[k], now[k]);
      }
    }
  }

  const LoadPath& path_;
  ArrayXd scale_;
  double damping_, least_;
  double omega_{}, period_{};  ///< of the interval
  SwingState state_;
  ArrayXd settled_, most_swing_;  ///< of the swing since it last grew
  ArrayXd reach_;                 ///< largest answer
  ArrayXd timed_, time_;          ///< the first that is like it
  std::vector<Onset> onsets_;
};

}  // namespace

ResponseSpectrum response_spectrum(const LoadPath& path,
                                   const Eigen::VectorXd& periods,
                                   double damping, double least) {
  ResponseSpectrum spectrum;
  if (path.size() < 2 || path.coordinates() == 0) return spectrum;
  const ArrayXd largest =
      path.values().rowwise().lpNorm<Eigen::Infinity>().array();
  for (const double period : periods) {
    const auto constant = Eigen::VectorXd::Constant(path.size(), period);
    Oscillators(path, largest, constant, damping, least).add_to(spectrum);
  }
  std::ranges::sort(spectrum.onsets);
  spectrum.onsets.erase(std::ranges::unique(spectrum.onsets).begin(),
                        spectrum.onsets.end());
  return spectrum;
}

double swept_amplification(const LoadPath& path, const Eigen::VectorXd& periods,
                           double damping) {
  constexpr double kAny = 1.0;
  ResponseSpectrum spectrum;
  if (path.size() < 2 || path.coordinates() == 0) return kAny;
  const ArrayXd largest =
      path.values().rowwise().lpNorm<Eigen::Infinity>().array();
  Oscillators(path, largest, periods, damping, kAny).add_to(spectrum);
  return spectrum.amplification;
}

}  // namespace clevis::dynamics
