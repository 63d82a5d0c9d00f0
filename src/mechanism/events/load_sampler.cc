#include "mechanism/events/load_sampler.h"

#include <algorithm>
#include <utility>

namespace clevis::mechanism {
namespace {

// Instants that stress analysis takes in seconds.
constexpr long kMostInstants = 4000;
constexpr int kDepth = 8;

}  // namespace

using Eigen::VectorXd;

LoadSampler::LoadSampler(EquationsOfMotion& equations, const VectorXd& largest)
    : equations_(equations),
      list_(equations.system(), equations.state().x, equations.forces()),
      change_(list_, largest),
      most_(kMostInstants) {
  state_.setZero(equations.layout().size());
}

void LoadSampler::restart(double t, const VectorXd& y) {
  const MotionSolution& solution = equations_.solve(t, y);
  taken_.t = t;
  list_.get(equations_.system(), solution.multipliers,
            equations_.state().loads.forces, taken_.loads);
}

LoadSampler::Sample LoadSampler::at(numerics::Integrator& integrator,
                                    double t) {
  integrator.interpolate(t, state_);
  const MotionSolution& solution = equations_.solve(t, state_);
  Sample sample{t, {}};
  list_.get(equations_.system(), solution.multipliers,
            equations_.state().loads.forces, sample.loads);
  return sample;
}

/// Halves the time between two samples until the loads change little.
void LoadSampler::divide(numerics::Integrator& integrator, const Sample& from,
                         const Sample& to, int depth,
                         std::vector<double>& wanted) {
  if (depth == 0 || most_ <= 0 || !change_.is_large(from.loads, to.loads)) {
    return;
  }
  const Sample middle = at(integrator, 0.5 * (from.t + to.t));
  divide(integrator, from, middle, depth - 1, wanted);
  --most_;
  wanted.push_back(middle.t);
  divide(integrator, middle, to, depth - 1, wanted);
}

void LoadSampler::look(numerics::Integrator& integrator, double until,
                       std::span<const double> known,
                       std::vector<double>& wanted) {
  constexpr int kParts = 4;
  const double start = integrator.t_start();
  std::vector<double> nodes;
  for (int i = 1; i <= kParts; ++i) {
    nodes.push_back(start + (until - start) * i / kParts);
  }
  const auto own = static_cast<std::ptrdiff_t>(nodes.size());
  for (const double t : known) {
    if (t > start && t <= until) nodes.push_back(t);
  }
  std::inplace_merge(nodes.begin(), nodes.begin() + own, nodes.end());
  Sample last = at(integrator, start);
  for (const double t : nodes) {
    if (t <= last.t) continue;
    Sample next = at(integrator, t);
    const bool is_instant = std::ranges::binary_search(known, t);
    if (most_ > 0 && change_.is_large(taken_.loads, next.loads)) {
      if (last.t > taken_.t) {
        wanted.push_back(last.t);
        --most_;
        taken_ = last;
      }
      if (change_.is_large(taken_.loads, next.loads)) {
        divide(integrator, last, next, kDepth, wanted);
        wanted.push_back(t);
        --most_;
        taken_ = next;
      }
    }
    if (is_instant) taken_ = next;
    last = std::move(next);
  }
}

}  // namespace clevis::mechanism
