#pragma once

#include <cmath>

#include <Eigen/Core>

namespace clevis::dynamics {

/// What vibration adds to quasi-static coordinates, and its rate per second.
struct SwingState {
  Eigen::ArrayXd w, rate;
};

/// w'' + 2 ζ ω w' + ω² w = −x'' − 2 ζ ω x' over an interval on which x is
/// cubic: free vibration about the particular solution b0 + b1 t + b2 t².
///
/// @tparam Omega  one ω for all coordinates (double), or one each (ArrayXd).
template <typename Omega>
class ForcedInterval {
 public:
  /// @param omega, damping  outlive the object [1/s], ζ < 1 [1].
  /// @param x  coordinates × 3: of t, t², t³.
  ForcedInterval(const Omega& omega, const Omega& damping,
                 const Eigen::ArrayX3d& x, const SwingState& start)
      : omega_(omega), damping_(damping) {
    const auto a1 = x.col(0), a2 = x.col(1), a3 = x.col(2);
    const Omega drag = 2.0 * damping * omega;
    const Omega square = omega * omega;
    b2_ = -3.0 * drag * a3 / square;
    b1_ = (-6.0 * a3 - 2.0 * drag * a2 - 2.0 * drag * b2_) / square;
    b0_ = (-2.0 * a2 - drag * a1 - drag * b1_ - 2.0 * b2_) / square;
    free_ = {start.w - b0_, start.rate - b1_};
  }

  /// @param t  since the interval's start [s].
  SwingState at(double t) const {
    using std::cos, std::exp, std::sin, std::sqrt;
    const Omega decay = exp(-damping_ * t * omega_);
    const Omega swing = sqrt(1.0 - damping_ * damping_) * omega_;
    const Omega c = cos(swing * t), s = sin(swing * t) / swing;
    return {
        decay * (c * free_.w + s * (free_.rate + damping_ * omega_ * free_.w)) +
            b0_ + t * (b1_ + t * b2_),
        decay * (c * free_.rate - s * (damping_ * omega_ * free_.rate +
                                       omega_ * omega_ * free_.w)) +
            b1_ + 2.0 * t * b2_};
  }

  /// At least |w| from the start until t.
  Eigen::ArrayXd bound(double t) const {
    using std::sqrt;
    const Omega swing = sqrt(1.0 - damping_ * damping_) * omega_;
    return (free_.w.square() +
            ((free_.rate + damping_ * omega_ * free_.w) / swing).square())
               .sqrt() +
           b0_.abs() + t * (b1_.abs() + t * b2_.abs());
  }

 private:
  const Omega& omega_;
  const Omega& damping_;
  Eigen::ArrayXd b0_, b1_, b2_;
  SwingState free_;
};

}  // namespace clevis::dynamics
