#include "mechanism/driven_loads/load_instants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <queue>

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

using At = DrivenTrajectory::At;

// How far loads may lie off the line between two instants, over the largest.
constexpr double kOffLine = 1.5e-3;
// The same while few instants are added.
constexpr double kOffLineOfFew = 5e-4;
constexpr std::size_t kFew = 50;
// Loads that lie so near to such a line at another time repeat what is there.
constexpr double kNear = 2.0 * kOffLine;
// So many instants are chosen before those that repeat others are left out.
constexpr std::size_t kBeforeRepeats = 500;

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

/// A look at the vertex of the parabola through a look and its neighbours.
/// @return its gain over `best`, which becomes that look if it is larger.
double LoadInstants::look_at_vertex(At top, const BodyLoads::Vector& vector,
                                    At& best) {
  constexpr double kKnown = 1.0 / 512.0;
  if (top == trajectory_.looks().begin() ||
      std::next(top) == trajectory_.looks().end()) {
    return 0.0;
  }
  const At before = std::prev(top), behind = std::next(top);
  if (before->breaks || top->breaks || scales_.beside(before->t) ||
      scales_.beside(behind->t)) {
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
  scales_.note(**look);
  const double gain = square(*look) - square(best);
  if (gain > 0.0) best = *look;
  return gain;
}

/// Makes an instant of the largest one of a load.
void LoadInstants::find_peak(const BodyLoads::Vector& vector, Index v) {
  constexpr int kMost = 6;
  constexpr double kGain = 1e-7, kRoundOff = 1e-12;
  const auto square = [&](const DrivenTrajectory::Look& look) {
    return look.loads.segment(vector.begin, vector.count).squaredNorm();
  };
  auto& looks = trajectory_.looks();
  At best = looks.end();
  double at_instants = 0.0;
  for (At i = looks.begin(); i != looks.end(); ++i) {
    if (scales_.beside(i->t)) continue;
    if (best == looks.end() || square(*i) > square(*best)) best = i;
    if (i->is_instant) at_instants = std::max(at_instants, square(*i));
  }
  const double scale = scales_.scales()[v];
  if (best == looks.end() || !(square(*best) > kGain * scale * scale)) return;
  for (int i = 0; i < kMost; ++i) {
    if (!(look_at_vertex(best, vector, best) > kGain * square(*best))) break;
  }
  if (square(*best) > (1.0 + kRoundOff) * at_instants) best->is_instant = true;
}

std::vector<At> LoadInstants::instants() {
  std::vector<At> instants;
  auto& looks = trajectory_.looks();
  for (At i = looks.begin(); i != looks.end(); ++i) {
    if (i->is_instant) instants.push_back(i);
  }
  return instants;
}

/// Whether a look lies on the line between two instants, whenever they are.
bool LoadInstants::is_covered(const DrivenTrajectory::Look& look,
                              const std::vector<At>& instants) const {
  const Index n = scales_.loads().size();
  for (std::size_t k = 0; k + 1 < instants.size(); ++k) {
    if (instants[k]->breaks) continue;
    const VectorXd& a = instants[k]->loads;
    const VectorXd& b = instants[k + 1]->loads;
    bool inside = true;
    for (Index i = 0; i < n && inside; ++i) {
      const double room =
          scales_.inverse()[i] > 0.0 ? kNear / scales_.inverse()[i] : 0.0;
      inside = look.loads[i] >= std::min(a[i], b[i]) - room &&
               look.loads[i] <= std::max(a[i], b[i]) + room;
    }
    if (!inside) continue;
    const VectorXd way = (b - a).cwiseProduct(scales_.inverse());
    const VectorXd to = (look.loads - a).cwiseProduct(scales_.inverse());
    const double length = way.squaredNorm();
    const double part =
        length > 0.0 ? std::clamp(way.dot(to) / length, 0.0, 1.0) : 0.0;
    if ((to - part * way).cwiseAbs().maxCoeff() <= kNear) return true;
  }
  return false;
}

void LoadInstants::choose(std::size_t most) {
  for (std::size_t v = 0; v < scales_.loads().vectors().size(); ++v) {
    if (!scales_.loads().vectors()[v].is_peak) continue;
    find_peak(scales_.loads().vectors()[v], static_cast<Index>(v));
  }
  scales_.update();
  std::priority_queue<LoadLines::Gap> gaps;
  std::vector<At> chosen = instants();
  for (std::size_t i = 0; i + 1 < chosen.size(); ++i) {
    gaps.push(lines_.gap(chosen[i], chosen[i + 1]));
  }
  std::size_t added = 0;
  const auto allowed = [&added] {
    return added < kFew ? kOffLineOfFew : kOffLine;
  };
  while (!gaps.empty() && gaps.top().defect > allowed() && added < most) {
    LoadLines::Gap top = gaps.top();
    gaps.pop();
    if (top.worst == trajectory_.looks().end()) {
      const auto look =
          trajectory_.look(top.left, 0.5 * (top.left->t + top.right->t));
      if (!look) continue;
      scales_.note(**look);
      top.worst = *look;
    } else if (added > kBeforeRepeats && is_covered(*top.worst, chosen)) {
      top.worst->repeats = true;
      gaps.push(lines_.gap(top.left, top.right));
      continue;
    }
    top.worst->is_instant = true;
    ++added;
    chosen.insert(std::ranges::upper_bound(chosen, top.worst->t, {},
                                           [](At look) {
                                             return look->t;
                                           }),
                  top.worst);
    gaps.push(lines_.gap(top.left, top.worst));
    gaps.push(lines_.gap(top.worst, top.right));
  }
}

double LoadInstants::follow(std::size_t most) {
  const std::vector<At> chosen = instants();
  std::size_t added = 0;
  for (std::size_t i = 0; i + 1 < chosen.size(); ++i) {
    std::vector<At> ends{chosen[i + 1]};  // rising from the last
    At left = chosen[i];
    while (!ends.empty()) {
      LoadLines::Gap here = lines_.curve_gap(left, ends.back());
      if (here.defect > 1.0 && here.worst == trajectory_.looks().end()) {
        const auto look =
            trajectory_.look(left, 0.5 * (left->t + ends.back()->t));
        if (look) here.worst = *look;
      }
      const bool is_line =
          here.worst == trajectory_.looks().end() || !(here.defect > 1.0);
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

std::vector<double> LoadInstants::unseen() {
  std::vector<double> unseen(scales_.loads().bodies(), 0.0);
  const auto& vectors = scales_.loads().vectors();
  const std::vector<At> chosen = instants();
  for (std::size_t k = 0; k + 1 < chosen.size(); ++k) {
    const At left = chosen[k], right = chosen[k + 1];
    if (lines_.is_closed(left, right)) continue;
    const VectorXd levels = lines_.levels(left, right);
    const auto note_excess = [&](const VectorXd& off) {
      for (std::size_t v = 0; v < vectors.size(); ++v) {
        const auto i = static_cast<Index>(v);
        for (const int body : vectors[v].bodies) {
          double& most = unseen[static_cast<std::size_t>(body)];
          most = std::max(most, levels[i] + off[i] - 1.0);
        }
      }
    };
    const auto cubic = std::next(left) == right
                           ? lines_.middle_by_cubic(left, right)
                           : std::nullopt;
    if (cubic) {
      note_excess(
          lines_.off_line(*cubic, 0.5 * (left->t + right->t), left, right));
    }
    for (At i = std::next(left); i != right; ++i) {
      note_excess(i->repeats ? VectorXd::Constant(levels.size(), kNear)
                             : lines_.off_line(i->loads, i->t, left, right));
    }
  }
  return unseen;
}

}  // namespace clevis::mechanism
