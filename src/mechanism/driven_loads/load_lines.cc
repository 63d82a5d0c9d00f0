#include "mechanism/driven_loads/load_lines.h"

#include <algorithm>
#include <iterator>

#include "mechanism/driven_loads/look_cubic.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

using At = DrivenTrajectory::At;

// Loads that come no nearer to the largest than this need no instant.
constexpr double kMatters = 0.03;
// Error of a cubic through two looks and those about, over the largest load.
constexpr double kOffCubic = 2.5e-4;
// Looks beside two, over which a load swings about as over those between.
constexpr int kBeside = 8;

}  // namespace

VectorXd LoadLines::levels(At left, At right) const {
  const VectorXd ends = scales_.loads()
                            .lengths(left->loads)
                            .cwiseMax(scales_.loads().lengths(right->loads));
  const auto part = [&](Index i) {
    return scales_.scales()[i] > 0.0 ? ends[i] / scales_.scales()[i] : 0.0;
  };
  std::vector<double> of_body(scales_.loads().bodies(), 0.0);
  const auto& vectors = scales_.loads().vectors();
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    for (const int body : vectors[v].bodies) {
      double& level = of_body[static_cast<std::size_t>(body)];
      level = std::max(level, part(static_cast<Index>(v)));
    }
  }
  VectorXd levels(ends.size());
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    const auto i = static_cast<Index>(v);
    levels[i] = part(i);
    for (const int body : vectors[v].bodies) {
      levels[i] = std::max(levels[i], of_body[static_cast<std::size_t>(body)]);
    }
  }
  return levels;
}

VectorXd LoadLines::off_line(const VectorXd& loads, double t, At left,
                             At right) const {
  const double part = (t - left->t) / (right->t - left->t);
  VectorXd off = scales_.loads().lengths(loads - (1.0 - part) * left->loads -
                                         part * right->loads);
  for (Index i = 0; i < off.size(); ++i) {
    off[i] = scales_.scales()[i] > 0.0 ? off[i] / scales_.scales()[i] : 0.0;
  }
  return off;
}

std::optional<VectorXd> LoadLines::middle_by_cubic(At left, At right) const {
  std::vector<At> about{left, right};
  const auto end = trajectory_.looks().end();
  const auto extend = [&](int before, int behind) {
    about = {left, right};
    At i = left;
    for (int k = 0; k < before; ++k) {
      if (i == trajectory_.looks().begin() || i->bends ||
          std::prev(i)->breaks) {
        return false;
      }
      about.insert(about.begin(), --i);
    }
    i = right;
    for (int k = 0; k < behind; ++k) {
      if (i->bends || i->breaks || std::next(i) == end) return false;
      about.push_back(++i);
    }
    return true;
  };
  if (!extend(1, 1) && !extend(0, 2) && !extend(2, 0)) return std::nullopt;
  return by_cubic(about, 0.5 * (left->t + right->t));
}

bool LoadLines::is_closed(At left, At right) const {
  return left->breaks || scales_.beside(left->t) || scales_.beside(right->t);
}

/// By load: half of its swing about two instants, over its scale.
VectorXd LoadLines::amplitudes(At left, At right) const {
  At from = left, to = std::next(right);
  for (int i = 0; i < kBeside && from != trajectory_.looks().begin(); ++i) {
    --from;
  }
  for (int i = 0; i < kBeside && to != trajectory_.looks().end(); ++i) ++to;
  VectorXd low = from->loads, high = from->loads;
  for (At i = from; i != to; ++i) {
    low = low.cwiseMin(i->loads);
    high = high.cwiseMax(i->loads);
  }
  const VectorXd swing = scales_.loads().lengths(high - low);
  return (scales_.scales().array() > 0.0)
      .select(0.5 * swing.array() / scales_.scales().array(), 0.0);
}

LoadLines::Gap LoadLines::gap(At left, At right) const {
  const VectorXd levels = this->levels(left, right);
  return worst_between(left, right, [&](const VectorXd& off, At look) {
    if (look != trajectory_.looks().end() && look->repeats) return 0.0;
    return ((levels + off).array() < kMatters)
        .select(0.0, off.array())
        .maxCoeff();
  });
}

/// What a cubic through both misses, over what it may: of a sine of amplitude a
/// it is 1.5 d²/a where the sine lies d off the line between them. What
/// vibrates makes small loads large.
LoadLines::Gap LoadLines::curve_gap(At left, At right) const {
  constexpr double kOfSine = 1.5, kRoundOff = 1e-12;
  const VectorXd largest =
      (kOffCubic / kOfSine * amplitudes(left, right)).cwiseSqrt();
  return worst_between(left, right, [&](const VectorXd& off, At) {
    return (off.array() > kRoundOff)
        .select(off.array() / largest.array(), 0.0)
        .maxCoeff();
  });
}

LoadLines::Gap LoadLines::worst_between(
    At left, At right,
    const std::function<double(const VectorXd& off, At look)>& defect_of)
    const {
  Gap result{.left = left, .right = right, .worst = trajectory_.looks().end()};
  if (is_closed(left, right)) return result;
  const auto judge = [&](const VectorXd& loads, double t, At look) {
    const double defect = defect_of(off_line(loads, t, left, right), look);
    if (defect <= result.defect) return;
    result.defect = defect;
    result.worst = look;
  };
  if (std::next(left) == right) {
    const auto cubic = middle_by_cubic(left, right);
    if (cubic) {
      judge(*cubic, 0.5 * (left->t + right->t), trajectory_.looks().end());
    }
    return result;
  }
  for (At i = std::next(left); i != right; ++i) {
    judge(i->loads, i->t, i);
  }
  return result;
}

}  // namespace clevis::mechanism
