#include "mechanism/driven_loads/load_trajectory.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mechanism/driven_loads/look_cubic.h"
#include "mechanism/sampling/driven_sampling.h"

namespace clevis::mechanism {

namespace {

using At = DrivenTrajectory::At;
using Piece = std::vector<At>;

// Error allowed to the cubic through a look's neighbours, over the largest;
// halfway between looks it then misses by a seventh of that.
constexpr double kResolved = 1.5e-3;
// Closer looks, over the duration, than these stand on both sides of a jump.
constexpr double kShortest = 8.0 * kSides;

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

}  // namespace

std::vector<Piece> LoadTrajectory::pieces() {
  std::vector<Piece> pieces(1);
  auto& looks = trajectory_.looks();
  for (At i = looks.begin(); i != looks.end(); ++i) {
    if (scales_.beside(i->t)) {
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
    const double miss = (piece[i]->loads - *cubic)
                            .cwiseAbs()
                            .cwiseProduct(scales_.inverse())
                            .maxCoeff();
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
      scales_.note(**look);
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
  scales_.update();
  return true;
}

}  // namespace clevis::mechanism
