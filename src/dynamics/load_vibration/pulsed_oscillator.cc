#include "dynamics/load_vibration/pulsed_oscillator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clevis::dynamics {

double pulsed_growth(const LoadPath& path, Eigen::Index coordinate,
                     const PulsedMode& mode) {
  constexpr double kSteps = 48.0;  // of a period
  const double omega = 2.0 * std::numbers::pi / mode.period;
  double most = 1.0;
  // Columns: from a place, from a speed; rows x, x'/ω.
  Eigen::Matrix2d state = Eigen::Matrix2d::Identity();
  for (Eigen::Index i = 0; i + 1 < path.size(); ++i) {
    const double length = path.time()[i + 1] - path.time()[i];
    if (path.is_jump(i)) continue;
    const auto count = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(std::ceil(length / mode.period * kSteps)));
    const double step = length / static_cast<double>(count);
    const Eigen::RowVector3d slopes = path.cubic(i).row(coordinate);
    const double from = path.values()(coordinate, i);
    const double turn = omega * step;
    const double kept = std::exp(-2.0 * mode.damping * turn);
    for (Eigen::Index k = 0; k < count; ++k) {
      const double t = (static_cast<double>(k) + 0.5) * step;
      const double now =
          from + t * (slopes[0] + t * (slopes[1] + t * slopes[2]));
      // Half a way, a kick, half a way: area of the phase plane is kept.
      state.row(0) += 0.5 * turn * state.row(1);
      state.row(1) -= turn * (1.0 - mode.share * now) * state.row(0);
      state.row(1) *= kept;
      state.row(0) += 0.5 * turn * state.row(1);
      most = std::max(most, state.colwise().norm().maxCoeff());
    }
  }
  return most;
}

}  // namespace clevis::dynamics
