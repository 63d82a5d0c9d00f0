#include "report/solid_picture/face_views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "report/solid_picture/digits.h"

namespace clevis::report {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTallest = 0.85;   // height of a view over its width
constexpr double kLeastRoom = 2.0;  // less is not seen [pixel]
constexpr int kMargin = 26;         // around the solid, for numbers [pixel]

/// Where a face has most room in a view.
struct Spot {
  double room = 0.0;  ///< distance to its visible rim [pixel]
  Vector2d at = Vector2d::Zero();
};

/// A view before it has numbers.
struct Candidate {
  FaceView view;
  std::vector<int> front;   ///< index of the face at each pixel, -1: none
  std::vector<Spot> spots;  ///< of each face
};

std::size_t index(const FaceView& view, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) +
         static_cast<std::size_t>(x);
}

/// Distance of each pixel from what bears another face, by chamfers of 1 and
/// √2.
std::vector<double> room_of(const FaceView& view,
                            const std::vector<int>& front) {
  std::vector<double> room(front.size(), 0.0);
  const auto sweep = [&](int x, int y, int sense) {
    const std::size_t here = index(view, x, y);
    double least = sense > 0 ? std::numeric_limits<double>::max() : room[here];
    for (const auto& [dx, dy] :
         {std::pair{-1, 0}, {-1, -1}, {0, -1}, {1, -1}}) {
      const int u = x + sense * dx, v = y + sense * dy;
      const double step = dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0;
      const bool is_inside =
          u >= 0 && v >= 0 && u < view.width && v < view.height;
      const bool is_same = is_inside && front[index(view, u, v)] == front[here];
      least = std::min(least,
                       is_same ? room[index(view, u, v)] + step : 0.5 * step);
    }
    room[here] = least;
  };
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) sweep(x, y, 1);
  }
  for (int y = view.height - 1; y >= 0; --y) {
    for (int x = view.width - 1; x >= 0; --x) sweep(x, y, -1);
  }
  return room;
}

/// Colours that black numbers stand out from; grey without a group.
std::array<std::uint8_t, 3> colour_of(const std::string& group,
                                      const std::vector<std::string>& groups) {
  constexpr std::array<std::array<std::uint8_t, 3>, 6> kColours{
      {{158, 202, 225},
       {253, 190, 133},
       {161, 217, 155},
       {250, 159, 181},
       {188, 189, 220},
       {255, 237, 111}}};
  const auto found = std::ranges::find(groups, group);
  if (group.empty() || found == groups.end()) return {214, 214, 214};
  return kColours[static_cast<std::size_t>(found - groups.begin()) %
                  kColours.size()];
}

std::vector<std::string> groups_of(const std::vector<DrawnFace>& faces) {
  std::vector<std::string> groups;
  for (const DrawnFace& face : faces) {
    if (!face.group.empty() &&
        std::ranges::find(groups, face.group) == groups.end()) {
      groups.push_back(face.group);
    }
  }
  return groups;
}

Eigen::MatrixX3d all_points(const std::vector<DrawnFace>& faces) {
  Eigen::Index count = 0;
  for (const DrawnFace& face : faces) count += face.points.rows();
  Eigen::MatrixX3d points(count, 3);
  Eigen::Index at = 0;
  for (const DrawnFace& face : faces) {
    points.middleRows(at, face.points.rows()) = face.points;
    at += face.points.rows();
  }
  return points;
}

Candidate seen_from(const std::vector<DrawnFace>& faces, const Sight& sight,
                    int width) {
  Candidate candidate;
  FaceView& view = candidate.view;
  const auto [placement, needed] =
      fitted(sight, all_points(faces), width - 2 * kMargin,
             kTallest * width - 2 * kMargin);
  view.placement = placement;
  view.placement.shift += Vector2d(kMargin, kMargin);
  view.width = width;
  view.height = static_cast<int>(std::ceil(needed)) + 2 * kMargin;
  const auto groups = groups_of(faces);
  Raster raster(view.width, view.height);
  for (const DrawnFace& face : faces) {
    Surface surface;
    surface.points = face.points;
    surface.triangles = face.triangles;
    surface.cell_triangles = {static_cast<int>(face.triangles.size())};
    surface.colour = colour_of(face.group, groups);
    raster.draw(surface, view.placement, 0.0);
  }
  view.rgb = raster.rgb();
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      candidate.front.push_back(raster.front(x, y));
    }
  }
  const auto room = room_of(view, candidate.front);
  candidate.spots.resize(faces.size());
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const std::size_t at = index(view, x, y);
      if (candidate.front[at] < 0) continue;
      Spot& spot =
          candidate.spots[static_cast<std::size_t>(candidate.front[at])];
      if (room[at] > spot.room) spot = {room[at], Vector2d(x + 0.5, y + 0.5)};
    }
  }
  return candidate;
}

/// Two opposite views askew, the other six, and along the axes. The longest
/// side lies across.
std::vector<Sight> sights(const std::vector<DrawnFace>& faces) {
  const Eigen::MatrixX3d points = all_points(faces);
  const Vector3d size =
      points.colwise().maxCoeff() - points.colwise().minCoeff();
  std::array<int, 3> order{0, 1, 2};  // longest first
  std::ranges::sort(order, std::ranges::greater{}, [&size](int axis) {
    return size[axis];
  });
  constexpr std::array<double, 3> kAskew{0.45, 0.6, 0.66};
  std::vector<Sight> all;
  for (const unsigned octant : {0U, 7U, 1U, 6U, 2U, 5U, 3U, 4U}) {
    Vector3d towards;
    for (std::size_t k = 0; k < 3; ++k) {
      towards[order[k]] = (octant >> k & 1U) != 0 ? -kAskew[k] : kAskew[k];
    }
    all.push_back(sight(towards, towards[order[1]] * Vector3d::Unit(order[0])));
  }
  for (const int axis : {order[2], order[1], order[0]}) {
    const Vector3d right =
        Vector3d::Unit(axis == order[0] ? order[1] : order[0]);
    for (const double sense : {1.0, -1.0}) {
      all.push_back(sight(sense * Vector3d::Unit(axis), sense * right));
    }
  }
  return all;
}

/// Half the number's box, with a rim [pixel].
Vector2d box_of(int number) {
  return half_size(std::to_string(number).size()) + Vector2d(3.0, 3.0);
}

bool has_room(const Spot& spot, int number) {
  return spot.room >= box_of(number).norm() - 3.0;
}

bool meets(const FaceNumber& other, const Vector2d& at, const Vector2d& box) {
  const Vector2d gap = (other.at - at).cwiseAbs() - box_of(other.number) - box;
  return gap.maxCoeff() < 0.0;
}

/// Pixels of a box that the solid covers; nothing if it leaves the picture.
std::optional<int> covered(const Candidate& candidate, const Vector2d& at,
                           const Vector2d& box) {
  const FaceView& view = candidate.view;
  const int left = static_cast<int>(at.x() - box.x());
  const int right = static_cast<int>(at.x() + box.x());
  const int top = static_cast<int>(at.y() - box.y());
  const int bottom = static_cast<int>(at.y() + box.y());
  if (left < 0 || top < 0 || right >= view.width || bottom >= view.height) {
    return std::nullopt;
  }
  int count = 0;
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      if (candidate.front[index(view, x, y)] >= 0) ++count;
    }
  }
  return count;
}

/// Beside a face that is too small for its number: near, beside the solid if
/// that can be, away from other numbers.
Vector2d place_beside(const Candidate& candidate, const Vector2d& dot,
                      int number) {
  constexpr int kDirections = 24;
  const Vector2d box = box_of(number);
  Vector2d best = dot;
  double best_cost = std::numeric_limits<double>::max();
  for (double away = 20.0; away < 160.0; away += 7.0) {
    for (int k = 0; k < kDirections; ++k) {
      const double turn = 2.0 * std::numbers::pi * k / kDirections;
      const Vector2d at = dot + away * Vector2d(std::cos(turn), std::sin(turn));
      const auto solid = covered(candidate, at, box);
      if (!solid) continue;
      double cost = away + 0.2 * *solid;
      for (const FaceNumber& other : candidate.view.numbers) {
        if (meets(other, at, box)) cost += 1e4;
      }
      if (cost < best_cost) {
        best_cost = cost;
        best = at;
      }
    }
  }
  return best;
}

/// How many faces a view shows that no view before it does.
int gain(const Candidate& candidate, const std::vector<double>& shown) {
  int count = 0;
  for (std::size_t f = 0; f < shown.size(); ++f) {
    if (shown[f] < kLeastRoom && candidate.spots[f].room >= kLeastRoom) ++count;
  }
  return count;
}

void take(Candidate candidate, std::vector<double>& shown,
          std::vector<Candidate>& taken) {
  for (std::size_t f = 0; f < shown.size(); ++f) {
    shown[f] = std::max(shown[f], candidate.spots[f].room);
  }
  taken.push_back(std::move(candidate));
}

/// Numbers that have room first: others keep away from them.
void write_numbers(const std::vector<DrawnFace>& faces,
                   const std::vector<double>& shown,
                   std::vector<Candidate>& taken) {
  for (Candidate& candidate : taken) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Spot& spot = candidate.spots[f];
      if (has_room(spot, faces[f].number)) {
        candidate.view.numbers.push_back({faces[f].number, spot.at, spot.at});
      }
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int number = faces[f].number;
    if (shown[f] < kLeastRoom || has_room({shown[f], {}}, number)) continue;
    const auto best =
        std::ranges::find_if(taken, [&](const Candidate& candidate) {
          return candidate.spots[f].room == shown[f];
        });
    const Vector2d dot = best->spots[f].at;
    best->view.numbers.push_back(
        {number, place_beside(*best, dot, number), dot});
  }
}

}  // namespace

FaceViews face_views(const std::vector<DrawnFace>& faces, int width) {
  const auto all = sights(faces);
  std::vector<double> shown(faces.size(), 0.0);
  std::vector<Candidate> taken, others;
  for (std::size_t k = 0; k < all.size(); ++k) {
    Candidate candidate = seen_from(faces, all[k], width);
    if (k < 2) {
      take(std::move(candidate), shown, taken);
    } else {
      others.push_back(std::move(candidate));
    }
  }
  while (!others.empty()) {
    const auto best =
        std::ranges::max_element(others, {}, [&](const Candidate& candidate) {
          return gain(candidate, shown);
        });
    if (gain(*best, shown) == 0) break;
    take(std::move(*best), shown, taken);
    others.erase(best);
  }
  write_numbers(faces, shown, taken);
  FaceViews result;
  for (Candidate& candidate : taken) {
    result.views.push_back(std::move(candidate.view));
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (shown[f] < kLeastRoom) result.hidden.push_back(faces[f].number);
  }
  return result;
}

}  // namespace clevis::report
