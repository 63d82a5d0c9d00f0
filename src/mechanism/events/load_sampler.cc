#include "mechanism/events/load_sampler.h"

#include <algorithm>
#include <utility>

namespace clevis::mechanism {
namespace {

// Instants that stress analysis takes in seconds.
constexpr long kMostInstants = 4000;
constexpr int kDepth = 8;
// The same of those that only vibration feels.
constexpr long kMostFollowed = 4000;
// Error of a cubic through times that are followed, over the largest load. Of a
// sine that swings by 2 a it is 1.5 d²/a, d being how far it lies off the line
// between two of them.
constexpr double kOffCubic = 2.5e-4;
// Samples that are kept from the last such time on.
constexpr std::size_t kMostSince = 64;
// Such times over which a load swings once at least.
constexpr std::size_t kSwing = 8;

}  // namespace

using Eigen::VectorXd;

LoadSampler::LoadSampler(EquationsOfMotion& equations, const VectorXd& largest)
    : equations_(equations),
      list_(equations.system(), equations.state().x, equations.forces()),
      change_(list_, largest),
      most_(kMostInstants),
      most_followed_(kMostFollowed) {
  state_.setZero(equations.layout().size());
}

void LoadSampler::restart(double t, const VectorXd& y) {
  const MotionSolution& solution = equations_.solve(t, y);
  taken_.t = t;
  list_.get(equations_.system(), solution.multipliers,
            equations_.state().loads.forces, taken_.loads);
  // Else loads go on from the end of the last step, with a bend or a jump.
  if (since_.empty()) since_ = {taken_};
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
  step_.push_back(middle);
  divide(integrator, middle, to, depth - 1, wanted);
}

/// How much a sample between two others misses of what cubics through times as
/// far apart may: more than 1 is too much.
double LoadSampler::off_curve(const Sample& from, const Sample& at,
                              const Sample& to) {
  constexpr double kOfSine = 1.5;
  const double part = (at.t - from.t) / (to.t - from.t);
  off_ = (1.0 - part) * from.loads + part * to.loads;
  change_.over_largest(at.loads, off_, miss_);
  if (!(kOfSine * miss_.maxCoeff() > kOffCubic * kOffCubic)) return 0.0;
  swing_.setZero(miss_.size());
  for (const auto* list : {&followed_, &since_}) {
    for (const Sample& other : *list) {
      change_.over_largest(other.loads, to.loads, apart_);
      swing_ = swing_.cwiseMax(apart_);
    }
  }
  // squares: miss² over half of the swing
  return (miss_.array() > 0.0)
      .select(
          2.0 * kOfSine * miss_.array() / (swing_.array().sqrt() * kOffCubic),
          0.0)
      .maxCoeff();
}

/// Adds samples to those of the step until no load is bent between them: half
/// as far apart they lie four times as near to a line.
void LoadSampler::straighten(numerics::Integrator& integrator) {
  constexpr double kBent = 16.0;  // of squares
  for (int depth = 0; depth < kDepth; ++depth) {
    std::vector<bool> is_halved(step_.size(), false);
    for (std::size_t i = 1; i + 1 < step_.size(); ++i) {
      if (off_curve(step_[i - 1], step_[i], step_[i + 1]) <= kBent) continue;
      is_halved[i - 1] = is_halved[i] = true;
    }
    if (std::ranges::find(is_halved, true) == is_halved.end()) return;
    std::vector<Sample> finer;
    for (std::size_t i = 0; i < step_.size(); ++i) {
      finer.push_back(std::move(step_[i]));
      if (!is_halved[i]) continue;
      finer.push_back(at(integrator, 0.5 * (finer.back().t + step_[i + 1].t)));
    }
    step_ = std::move(finer);
  }
}

/// Takes the last sample before the loads leave the curve from the last time
/// that is an instant or followed.
void LoadSampler::follow(std::span<const double> known,
                         std::vector<double>& wanted,
                         std::vector<double>& followed) {
  const auto is_instant = [known, own = wanted](double t) {
    return std::ranges::binary_search(known, t) ||
           std::ranges::find(own, t) != own.end();
  };
  const auto leaves = [this](const Sample& to) {
    for (std::size_t i = 1; i < since_.size(); ++i) {
      if (off_curve(since_.front(), since_[i], to) > 1.0) return true;
    }
    return false;
  };
  const auto go_on_from = [this](Sample sample) {
    followed_.push_back(sample);
    if (followed_.size() > kSwing) followed_.erase(followed_.begin());
    since_ = {std::move(sample)};
  };
  for (Sample& sample : step_) {
    if (sample.t <= since_.back().t) continue;
    if (since_.size() > 1 && leaves(sample)) {
      if (most_followed_ > 0) {
        --most_followed_;
        // once no further instants are taken these stand for them
        (most_ > 0 ? followed : wanted).push_back(since_.back().t);
      } else {
        followed_until_ = std::min(followed_until_, since_.front().t);
        step_behind_ =
            std::min(step_behind_, since_.back().t - since_.front().t);
      }
      go_on_from(since_.back());
    }
    if (is_instant(sample.t)) {
      go_on_from(std::move(sample));
      continue;
    }
    since_.push_back(std::move(sample));
    if (since_.size() <= kMostSince) continue;
    for (std::size_t i = 1; 2 * i < since_.size(); ++i) {
      since_[i] = std::move(since_[2 * i]);
    }
    since_.resize(since_.size() / 2 + 1);
  }
}

void LoadSampler::look(numerics::Integrator& integrator, double until,
                       std::span<const double> known,
                       std::vector<double>& wanted,
                       std::vector<double>& followed) {
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
  step_ = {last};
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
    step_.push_back(next);
    last = std::move(next);
  }
  if (list_.size() == 0) return;
  std::ranges::sort(step_, {}, &Sample::t);
  straighten(integrator);
  follow(known, wanted, followed);
}

}  // namespace clevis::mechanism
