#include "assessment/stretches/counting_springs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <Eigen/Core>

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A frequency by itself, and the width of its resonance [1].
struct Resonance {
  double square{}, width{};
};

}  // namespace

bool springs_count(const elasticity::SeatShapes& shapes,
                   const loads::SeatHold& hold, double damping,
                   double duration) {
  constexpr double kOfWidth = 0.1, kShort = 0.1;  // periods of a motion
  constexpr double kMost = 0.02, kRoundOff = 1e-6;
  constexpr double kHolding = 0.1;  // damping ratio
  constexpr double kElastic = 0.5;  // of the first square; less: rigid bodies'
  constexpr std::size_t kFirst = 6;
  if (!hold.is_sprung()) return false;
  loads::SeatHold unsprung = hold;
  unsprung.leave_springs_out();
  const auto held = shapes.held_by(hold);
  const VectorXd& sprung = held.squares;
  const VectorXd alone = shapes.held_by(unsprung).squares;
  const auto rigid = shapes.rigid_swings(hold);
  std::vector<Resonance> apart;
  const auto add = [&](double square, double ratio) {
    const double periods =
        std::sqrt(std::max(square, 0.0)) * duration / 2.0 / std::numbers::pi;
    const double width = std::max(ratio, kShort / std::max(periods, kShort));
    apart.push_back({square, std::min(kMost, width)});
  };
  for (const double square : alone) add(square, damping);
  for (Index k = 0; k < rigid.squares.size(); ++k) {
    add(rigid.squares[k], rigid.damping[k]);
  }
  std::ranges::sort(apart, {}, &Resonance::square);
  const std::size_t count =
      std::min({kFirst + static_cast<std::size_t>(rigid.squares.size()),
                apart.size(), static_cast<std::size_t>(sprung.size())});
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [square, width] = apart[k];
    const double moved = std::abs(sprung[static_cast<Index>(k)] - square);
    if (moved > (2.0 * kOfWidth * width + kRoundOff) * square ||
        (sprung[static_cast<Index>(k)] > kElastic * alone[0] &&
         held.damping[static_cast<Index>(k)] > kHolding)) {
      return true;
    }
  }
  return false;
}

}  // namespace clevis::assessment
