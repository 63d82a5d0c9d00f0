#include "mechanism/driven_search/load_trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <queue>
#include <utility>

#include "mechanism/sampling/driven_sampling.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

using At = DrivenTrajectory::At;
using Piece = std::vector<At>;

// Error allowed to the cubic through a look's neighbours, over the largest;
// halfway between looks it then misses by a seventh of that.
constexpr double kResolved = 5e-3;
// How far loads may lie off the line between two instants, likewise.
constexpr double kOffLine = 1.5e-3;
// The same while few instants are added.
constexpr double kOffLineOfFew = 5e-4;
constexpr std::size_t kFew = 50;
// And between those that repeat others, which a cubic joins.
constexpr double kOffLineOfRepeats = 6e-3;
// Loads that lie so near to such a line at another time repeat what is there.
constexpr double kNear = 2.0 * kOffLine;
// Loads that come no nearer to the largest than this need no instant.
constexpr double kMatters = 0.03;
// Closer looks, over the duration, than these stand on both sides of a jump.
constexpr double kShortest = 8.0 * kSides;
// So many instants are chosen before those that repeat others are left out.
constexpr std::size_t kBeforeRepeats = 500;

/// Weights of the polynomial through some times, at another.
template <std::size_t n>
std::array<double, n> lagrange(const std::array<double, n>& t, double at) {
  std::array<double, n> weights;
  for (std::size_t j = 0; j < n; ++j) {
    weights[j] = 1.0;
    for (std::size_t k = 0; k < n; ++k) {
      if (k != j) weights[j] *= (at - t[k]) / (t[j] - t[k]);
    }
  }
  return weights;
}

/// Up to `count` looks beside one on one side, so far apart that their
/// difference is more than round-off.
void neighbours(const Piece& piece, std::size_t i, int step, std::size_t count,
                std::vector<At>& found) {
  constexpr double kApart = 0.05;
  const double t = piece[i]->t;
  double last = 0.0;
  for (auto k = static_cast<std::ptrdiff_t>(i) + step;
       count > 0 && k >= 0 && k < static_cast<std::ptrdiff_t>(piece.size());
       k += step) {
    const At look = piece[static_cast<std::size_t>(k)];
    const double away = std::abs(look->t - t);
    if (away - last < kApart * away) continue;
    last = away;
    found.push_back(look);
    --count;
  }
}

/// Loads at a time by the four looks about it; nothing if there
/// are fewer.
std::optional<VectorXd> by_cubic(const std::vector<At>& about, double t) {
  if (about.size() != 4) return std::nullopt;
  const std::array<double, 4> times{about[0]->t, about[1]->t, about[2]->t,
                                    about[3]->t};
  const auto weights = lagrange(times, t);
  VectorXd value = weights[0] * about[0]->loads;
  for (std::size_t k = 1; k < 4; ++k) value += weights[k] * about[k]->loads;
  return value;
}

/// The look's own neighbours: two on each side, or more on one.
std::vector<At> about(const Piece& piece, std::size_t i) {
  std::vector<At> before, behind, found;
  neighbours(piece, i, -1, 3, before);
  neighbours(piece, i, 1, 3, behind);
  std::size_t left = std::min<std::size_t>(2, before.size());
  std::size_t right = std::min<std::size_t>(2, behind.size());
  if (left < 2) right = std::min(4 - left, behind.size());
  if (right < 2) left = std::min(4 - right, before.size());
  found.assign(before.begin(),
               before.begin() + static_cast<std::ptrdiff_t>(left));
  found.insert(found.end(), behind.begin(),
               behind.begin() + static_cast<std::ptrdiff_t>(right));
  return found;
}

/// Time of the vertex of the parabola through three points; the middle one's
/// if they lie on a line.
double vertex(const std::array<double, 3>& t, const std::array<double, 3>& v) {
  const double left = (v[1] - v[0]) / (t[1] - t[0]);
  const double right = (v[2] - v[1]) / (t[2] - t[1]);
  const double curvature = (right - left) / (t[2] - t[0]);
  if (!(curvature < 0.0)) return t[1];
  const double at = 0.5 * (t[0] + t[1]) - 0.5 * left / curvature;
  return std::clamp(at, t[0], t[2]);
}

}  // namespace

LoadTrajectory::LoadTrajectory(DrivenTrajectory& trajectory,
                               std::function<bool(double)> beside)
    : trajectory_(trajectory),
      loads_(trajectory.loads()),
      beside_(std::move(beside)) {
  const auto vectors = static_cast<Index>(loads_.vectors().size());
  largest_.setZero(vectors);
  inverse_.setZero(loads_.size());
  note_all();
}

void LoadTrajectory::note(const DrivenTrajectory::Look& look) {
  if (!beside_(look.t)) {
    largest_ = largest_.cwiseMax(loads_.lengths(look.loads));
  }
}

void LoadTrajectory::note_all() {
  for (const auto& look : trajectory_.looks()) note(look);
  scales_ = loads_.scales(largest_);
  for (std::size_t v = 0; v < loads_.vectors().size(); ++v) {
    const BodyLoads::Vector& vector = loads_.vectors()[v];
    const double scale = scales_[static_cast<Index>(v)];
    inverse_.segment(vector.begin, vector.count)
        .setConstant(scale > 0.0 ? 1.0 / scale : 0.0);
  }
}

std::vector<Piece> LoadTrajectory::pieces() {
  std::vector<Piece> pieces(1);
  auto& looks = trajectory_.looks();
  for (At i = looks.begin(); i != looks.end(); ++i) {
    if (beside_(i->t)) {
      if (!pieces.back().empty()) pieces.emplace_back();
      continue;
    }
    pieces.back().push_back(i);
    if (i->breaks) {
      pieces.emplace_back();
    } else if (i->bends) {
      pieces.push_back({i});
    }
  }
  std::erase_if(pieces, [](const Piece& piece) {
    return piece.size() < 2;
  });
  return pieces;
}

/// Looks behind which the interval is to be halved, by index.
std::vector<std::size_t> LoadTrajectory::unresolved(const Piece& piece) const {
  constexpr double kMuchShorter = 0.25;
  const std::size_t n = piece.size();
  std::vector<std::size_t> found;
  const auto length = [&](std::size_t i) {
    return piece[i + 1]->t - piece[i]->t;
  };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const std::size_t from = i - std::min<std::size_t>(i, 2);
    const std::size_t to = std::min(n, i + 3);
    bool changed = false;
    for (std::size_t k = from; k < to; ++k) changed |= piece[k]->is_new;
    if (!changed) continue;
    const auto cubic = by_cubic(about(piece, i), piece[i]->t);
    if (!cubic) continue;
    const double miss =
        (piece[i]->loads - *cubic).cwiseAbs().cwiseProduct(inverse_).maxCoeff();
    if (!(miss > kResolved)) continue;
    if (length(i - 1) > kMuchShorter * length(i)) found.push_back(i - 1);
    if (length(i) > kMuchShorter * length(i - 1)) found.push_back(i);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool LoadTrajectory::refine_piece(Piece piece, std::size_t most) {
  constexpr std::size_t kLeast = 5;
  const double shortest = kShortest * trajectory_.duration();
  if (piece.back()->t - piece.front()->t < shortest) return true;
  while (trajectory_.looks().size() < most) {
    std::vector<std::size_t> halved;
    if (piece.size() < kLeast) {
      std::size_t longest = 0;
      for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
        if (piece[i + 1]->t - piece[i]->t >
            piece[longest + 1]->t - piece[longest]->t) {
          longest = i;
        }
      }
      halved.push_back(longest);
    } else {
      halved = unresolved(piece);
      for (const At look : piece) look->is_new = false;
    }
    bool any = false;
    for (auto i = halved.rbegin(); i != halved.rend(); ++i) {
      const At left = piece[*i], right = piece[*i + 1];
      if (right->t - left->t < shortest) {
        left->is_instant = right->is_instant = left->breaks = true;
        continue;
      }
      const auto look = trajectory_.look(left, 0.5 * (left->t + right->t));
      if (!look) continue;
      note(**look);
      any = true;
      piece.insert(piece.begin() + static_cast<std::ptrdiff_t>(*i) + 1, *look);
    }
    if (!any) return true;
  }
  return false;
}

bool LoadTrajectory::refine(std::size_t most) {
  for (const Piece& piece : pieces()) {
    if (!refine_piece(piece, most)) return false;
    ended_at_ = piece.back()->t;
  }
  note_all();
  return true;
}

/// A look at the vertex of the parabola through a look and its neighbours.
/// @return its gain over `best`, which becomes that look if it is larger.
double LoadTrajectory::look_at_vertex(At top, const BodyLoads::Vector& vector,
                                      At& best) {
  constexpr double kKnown = 1.0 / 512.0;
  if (top == trajectory_.looks().begin() ||
      std::next(top) == trajectory_.looks().end()) {
    return 0.0;
  }
  const At before = std::prev(top), behind = std::next(top);
  if (before->breaks || top->breaks || beside_(before->t) ||
      beside_(behind->t)) {
    return 0.0;
  }
  const auto square = [&](At look) {
    return look->loads.segment(vector.begin, vector.count).squaredNorm();
  };
  const double t = vertex({before->t, top->t, behind->t},
                          {square(before), square(top), square(behind)});
  const double apart = kKnown * (behind->t - before->t);
  if (t - before->t < apart || behind->t - t < apart ||
      std::abs(t - top->t) < apart) {
    return 0.0;
  }
  const auto look = trajectory_.look(t < top->t ? before : top, t);
  if (!look) return 0.0;
  note(**look);
  const double gain = square(*look) - square(best);
  if (gain > 0.0) best = *look;
  return gain;
}

/// Makes an instant of the largest one of a load.
void LoadTrajectory::find_peak(const BodyLoads::Vector& vector, Index v) {
  constexpr int kMost = 6;
  constexpr double kGain = 1e-7, kRoundOff = 1e-12;
  const auto square = [&](const DrivenTrajectory::Look& look) {
    return look.loads.segment(vector.begin, vector.count).squaredNorm();
  };
  auto& looks = trajectory_.looks();
  At best = looks.end();
  double at_instants = 0.0;
  for (At i = looks.begin(); i != looks.end(); ++i) {
    if (beside_(i->t)) continue;
    if (best == looks.end() || square(*i) > square(*best)) best = i;
    if (i->is_instant) at_instants = std::max(at_instants, square(*i));
  }
  const double scale = scales_[v];
  if (best == looks.end() || !(square(*best) > kGain * scale * scale)) return;
  for (int i = 0; i < kMost; ++i) {
    if (!(look_at_vertex(best, vector, best) > kGain * square(*best))) break;
  }
  if (square(*best) > (1.0 + kRoundOff) * at_instants) best->is_instant = true;
}

std::vector<At> LoadTrajectory::instants() {
  std::vector<At> instants;
  auto& looks = trajectory_.looks();
  for (At i = looks.begin(); i != looks.end(); ++i) {
    if (i->is_instant) instants.push_back(i);
  }
  return instants;
}

/// By load: the greatest part of its largest that any load of its bodies has
/// at two instants.
VectorXd LoadTrajectory::levels(At left, At right) const {
  const VectorXd ends =
      loads_.lengths(left->loads).cwiseMax(loads_.lengths(right->loads));
  const auto part = [&](Index i) {
    return scales_[i] > 0.0 ? ends[i] / scales_[i] : 0.0;
  };
  std::vector<double> of_body(loads_.bodies(), 0.0);
  const auto& vectors = loads_.vectors();
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

/// By load: how far off the line between two instants, over its scale.
VectorXd LoadTrajectory::off_line(const VectorXd& loads, double t, At left,
                                  At right) const {
  const double part = (t - left->t) / (right->t - left->t);
  VectorXd off =
      loads_.lengths(loads - (1.0 - part) * left->loads - part * right->loads);
  for (Index i = 0; i < off.size(); ++i) {
    off[i] = scales_[i] > 0.0 ? off[i] / scales_[i] : 0.0;
  }
  return off;
}

/// Between neighbours: what the cubic through those about says of the middle.
std::optional<VectorXd> LoadTrajectory::middle_by_cubic(At left,
                                                        At right) const {
  Piece about{left, right};
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

/// Where two instants have none between that could be larger.
bool LoadTrajectory::is_closed(At left, At right) const {
  return left->breaks || beside_(left->t) || beside_(right->t);
}

LoadTrajectory::Gap LoadTrajectory::gap(At left, At right,
                                        bool repeats_count) const {
  Gap result{.left = left, .right = right, .worst = trajectory_.looks().end()};
  if (is_closed(left, right)) return result;
  const VectorXd levels = this->levels(left, right);
  const auto judge = [&](const VectorXd& loads, double t, At look) {
    const VectorXd off = off_line(loads, t, left, right);
    const double defect =
        ((levels + off).array() < kMatters).select(0.0, off.array()).maxCoeff();
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
    if (repeats_count || !i->repeats) judge(i->loads, i->t, i);
  }
  return result;
}

/// Whether a look lies on the line between two instants, whenever they are.
bool LoadTrajectory::is_covered(const DrivenTrajectory::Look& look,
                                const std::vector<At>& instants) const {
  const Index n = loads_.size();
  for (std::size_t k = 0; k + 1 < instants.size(); ++k) {
    if (instants[k]->breaks) continue;
    const VectorXd& a = instants[k]->loads;
    const VectorXd& b = instants[k + 1]->loads;
    bool inside = true;
    for (Index i = 0; i < n && inside; ++i) {
      const double room = inverse_[i] > 0.0 ? kNear / inverse_[i] : 0.0;
      inside = look.loads[i] >= std::min(a[i], b[i]) - room &&
               look.loads[i] <= std::max(a[i], b[i]) + room;
    }
    if (!inside) continue;
    const VectorXd way = (b - a).cwiseProduct(inverse_);
    const VectorXd to = (look.loads - a).cwiseProduct(inverse_);
    const double length = way.squaredNorm();
    const double part =
        length > 0.0 ? std::clamp(way.dot(to) / length, 0.0, 1.0) : 0.0;
    if ((to - part * way).cwiseAbs().maxCoeff() <= kNear) return true;
  }
  return false;
}

void LoadTrajectory::choose(std::size_t most) {
  for (std::size_t v = 0; v < loads_.vectors().size(); ++v) {
    if (!loads_.vectors()[v].is_peak) continue;
    find_peak(loads_.vectors()[v], static_cast<Index>(v));
  }
  note_all();
  std::priority_queue<Gap> gaps;
  std::vector<At> chosen = instants();
  for (std::size_t i = 0; i + 1 < chosen.size(); ++i) {
    gaps.push(gap(chosen[i], chosen[i + 1]));
  }
  std::size_t added = 0;
  const auto allowed = [&added] {
    return added < kFew ? kOffLineOfFew : kOffLine;
  };
  while (!gaps.empty() && gaps.top().defect > allowed() && added < most) {
    Gap top = gaps.top();
    gaps.pop();
    if (top.worst == trajectory_.looks().end()) {
      const auto look =
          trajectory_.look(top.left, 0.5 * (top.left->t + top.right->t));
      if (!look) continue;
      note(**look);
      top.worst = *look;
    } else if (added > kBeforeRepeats && is_covered(*top.worst, chosen)) {
      top.worst->repeats = true;
      gaps.push(gap(top.left, top.right));
      continue;
    }
    top.worst->is_instant = true;
    ++added;
    chosen.insert(std::ranges::upper_bound(chosen, top.worst->t, {},
                                           [](At look) {
                                             return look->t;
                                           }),
                  top.worst);
    gaps.push(gap(top.left, top.worst));
    gaps.push(gap(top.worst, top.right));
  }
}

double LoadTrajectory::follow(std::size_t most) {
  const std::vector<At> chosen = instants();
  std::size_t added = 0;
  for (std::size_t i = 0; i + 1 < chosen.size(); ++i) {
    std::vector<At> ends{chosen[i + 1]};  // rising from the last
    At left = chosen[i];
    while (!ends.empty()) {
      Gap here = gap(left, ends.back(), true);
      if (here.defect > kOffLineOfRepeats &&
          here.worst == trajectory_.looks().end()) {
        const auto look =
            trajectory_.look(left, 0.5 * (left->t + ends.back()->t));
        if (look) here.worst = *look;
      }
      const bool is_line = here.worst == trajectory_.looks().end() ||
                           !(here.defect > kOffLineOfRepeats);
      if (is_line) {
        left = ends.back();
        ends.pop_back();
        continue;
      }
      if (added == most) return left->t;
      here.worst->follows = true;
      ends.push_back(here.worst);
      ++added;
    }
  }
  return trajectory_.duration();
}

std::vector<double> LoadTrajectory::unseen() {
  std::vector<double> unseen(loads_.bodies(), 0.0);
  const auto& vectors = loads_.vectors();
  const std::vector<At> chosen = instants();
  for (std::size_t k = 0; k + 1 < chosen.size(); ++k) {
    const At left = chosen[k], right = chosen[k + 1];
    if (is_closed(left, right)) continue;
    const VectorXd levels = this->levels(left, right);
    const auto note_excess = [&](const VectorXd& off) {
      for (std::size_t v = 0; v < vectors.size(); ++v) {
        const auto i = static_cast<Index>(v);
        for (const int body : vectors[v].bodies) {
          double& most = unseen[static_cast<std::size_t>(body)];
          most = std::max(most, levels[i] + off[i] - 1.0);
        }
      }
    };
    const auto cubic =
        std::next(left) == right ? middle_by_cubic(left, right) : std::nullopt;
    if (cubic) {
      note_excess(off_line(*cubic, 0.5 * (left->t + right->t), left, right));
    }
    for (At i = std::next(left); i != right; ++i) {
      note_excess(i->repeats ? VectorXd::Constant(levels.size(), kNear)
                             : off_line(i->loads, i->t, left, right));
    }
  }
  return unseen;
}

}  // namespace clevis::mechanism
