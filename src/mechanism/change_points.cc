// The change points of a driven motion.
#include <algorithm>
#include <array>
#include <utility>

#include "mechanism/body_motion.h"
#include "mechanism/driven_motion.h"

namespace clevis::mechanism {
namespace {

// of the time between two instants, in search of change points
constexpr int kHalvings = 300;

std::vector<Twist> between(std::vector<Twist> a, const std::vector<Twist>& b,
                           double part) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i].v += part * (b[i].v - a[i].v);
    a[i].w += part * (b[i].w - a[i].w);
  }
  return a;
}

}  // namespace

/// A time between two positions at which J loses rank, if there is one. Its
/// smallest singular value with its sign tells: u, v those of one end, uᵀ J v
/// at the other end is negative behind a change point. Where it has changed by
/// half, the interval is halved. det J tells of others that pass zero; it keeps
/// its sign where two loops lose rank at once, and redundant mechanisms have
/// none.
/// @param halvings  left to do.
std::optional<double> DrivenMotion::singular_between(const Moment& from,
                                                     const Moment& to,
                                                     int& halvings) const {
  const auto remains = [](const Moment& a, const Moment& b) {
    return a.weakest.u.dot(b.at.jacobian * a.weakest.v) > 0.5 * a.weakest.sigma;
  };
  const bool same_sign =
      from.at.factor.determinant_sign() == to.at.factor.determinant_sign();
  if ((same_sign && remains(from, to) && remains(to, from)) || halvings == 0) {
    return std::nullopt;
  }
  --halvings;
  const double t = 0.5 * (from.t + to.t);
  const Moment middle(follow(from.at, t), t);
  if (!middle.at.factor.full_column_rank()) return t;
  if (const auto hit = singular_between(from, middle, halvings)) return hit;
  return singular_between(middle, to, halvings);
}

/// Just outside the times around t_hit at which J has no full rank: before
/// and behind. Each bisection starts from the last regular position.
std::array<DrivenMotion::Moment, 2> DrivenMotion::singular_interval(
    const Moment& from, double t_hit, const Moment& to) const {
  const auto edge = [this, t_hit](Moment regular) {
    double singular = t_hit;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (regular.t + singular);
      ClosedConfiguration at = follow(regular.at, middle);
      if (at.factor.full_column_rank()) {
        regular = Moment(std::move(at), middle);
      } else {
        singular = middle;
      }
    }
    return regular;
  };
  return {edge(from), edge(to)};
}

/// The change point at t on the way from a regular position: rates are
/// interpolated between the nearest clearly regular positions on both sides,
/// forces those of joints that give way.
std::optional<Instant> DrivenMotion::change_point(const Moment& from, double t,
                                                  double t_step) const {
  for (double step = 1e-3 * t_step; step <= t_step; step *= 2.0) {
    const double t_low = std::max(t - step, from.t), t_high = t + step;
    const ClosedConfiguration before = follow(from.at, t_low);
    const ClosedConfiguration behind = follow(from.at, t_high);
    if (!before.factor.full_column_rank() ||
        !behind.factor.full_column_rank()) {
      continue;
    }
    const ClosedConfiguration at = follow(before, t);
    const double part = (t - t_low) / (t_high - t_low);
    const Rates low = rates(before, t_low), high = rates(behind, t_high);
    const Rates here{between(low.twists, high.twists, part),
                     between(low.accelerations, high.accelerations, part)};
    Instant result = kinematics(at, t, here);
    const std::vector<Twist> applied = elements(at, here, result);
    auto forces = equilibrium_.solve_compliant(at.x, at.placed, here.twists,
                                               here.accelerations, applied);
    if (!forces) return std::nullopt;
    put_forces(frame_, system_, at.placed, std::move(*forces), result);
    result.is_change_point = true;
    return result;
  }
  return std::nullopt;
}

/// Notes the change points between two regular instants.
void DrivenMotion::note_change_points(const Moment& from, const Moment& to,
                                      AtSingularity policy,
                                      Motion& motion) const {
  Moment at = from;
  int halvings = kHalvings;
  while (const auto hit = singular_between(at, to, halvings)) {
    auto [before, behind] = singular_interval(at, *hit, to);
    const double t = 0.5 * (before.t + behind.t);
    if (policy == AtSingularity::kStop) {
      refuse_change_point(follow(before.at, t), t);
    }
    motion.change_points.push_back(
        {from.t, to.t, t, change_point(at, t, to.t - from.t)});
    at = std::move(behind);
  }
}

}  // namespace clevis::mechanism
