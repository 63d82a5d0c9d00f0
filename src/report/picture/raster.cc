#include "report/picture/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "report/page/page_assets.h"
#include "report/picture/png.h"

namespace clevis::report {
namespace {

constexpr int kFiner = 2;  // pixels of the finer grid, along each side of one
constexpr float kNothing = -std::numeric_limits<float>::infinity();
constexpr int kShades = 256;
using Colour = std::array<std::uint8_t, 3>;

std::vector<Colour> shades() {
  std::vector<std::array<double, 3>> given;
  for (const std::string& text : stress_colours()) {
    std::array<double, 3> colour{};
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] = std::stoi(text.substr(2 * c, 2), nullptr, 16);
    }
    given.push_back(colour);
  }
  std::vector<Colour> all;
  for (int k = 0; k < kShades; ++k) {
    const double at = static_cast<double>(k) / (kShades - 1) *
                      static_cast<double>(given.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), given.size() - 2);
    const double part = at - static_cast<double>(low);
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] = static_cast<std::uint8_t>(std::lround(
          given[low][c] + part * (given[low + 1][c] - given[low][c])));
    }
    all.push_back(colour);
  }
  return all;
}

const Colour& shade(double share) {
  static const std::vector<Colour> kAll = shades();
  const double at = std::clamp(share, 0.0, 1.0) * (kShades - 1);
  return kAll[static_cast<std::size_t>(std::lround(at))];
}

using Edge = std::pair<int, int>;

/// Edges of one triangle alone.
std::vector<Edge> single_edges(std::span<const std::array<int, 3>> triangles) {
  std::vector<Edge> all;
  for (const auto& corners : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      all.push_back(std::minmax({corners[k], corners[(k + 1) % 3]}));
    }
  }
  std::ranges::sort(all);
  std::vector<Edge> single;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool has_twin = (k > 0 && all[k - 1] == all[k]) ||
                          (k + 1 < all.size() && all[k + 1] == all[k]);
    if (!has_twin) single.push_back(all[k]);
  }
  return single;
}

/// Edges of the mesh: those of one triangle of a cell alone.
std::vector<Edge> mesh_edges(const Surface& surface) {
  std::vector<Edge> edges;
  std::span<const std::array<int, 3>> rest(surface.triangles);
  for (const int count : surface.cell_triangles) {
    const auto of_cell =
        single_edges(rest.first(static_cast<std::size_t>(count)));
    edges.insert(edges.end(), of_cell.begin(), of_cell.end());
    rest = rest.subspan(static_cast<std::size_t>(count));
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

std::vector<std::string> stress_colours() {
  return nlohmann::ordered_json::parse(viewer_colours())
      .get<std::vector<std::string>>();
}

Eigen::Vector2d Placement::at(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d seen = sight * place;
  return shift + scale * Eigen::Vector2d(seen.x(), -seen.y());
}

Fitted fitted(const Sight& sight, const Eigen::MatrixX3d& places, double width,
              double highest) {
  constexpr double kMargin = 12.0;  // [pixel]
  const Eigen::MatrixX3d seen = places * sight.transpose();
  const Eigen::Vector3d low = seen.colwise().minCoeff(),
                        high = seen.colwise().maxCoeff();
  const Eigen::Vector3d size =
      (high - low).cwiseMax(1e-9 * (high - low).norm()).cwiseMax(1e-30);
  const double scale = std::min((width - 2.0 * kMargin) / size.x(),
                                (highest - 2.0 * kMargin) / size.y());
  const double height = scale * size.y() + 2.0 * kMargin;
  return {{sight,
           scale,
           {0.5 * width - 0.5 * scale * (low.x() + high.x()),
            0.5 * height + 0.5 * scale * (low.y() + high.y())}},
          height};
}

Raster::Raster(int width, int height)
    : width_(kFiner * width),
      height_(kFiner * height),
      depth_(
          static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
          kNothing),
      front_(depth_.size(), -1),
      pixels_(3 * depth_.size(), 255) {}

void Raster::begin_layer() {
  std::ranges::fill(depth_, kNothing);
}

void Raster::draw(const Surface& surface, const Placement& placement,
                  double largest) {
  constexpr double kDarkest = 0.6;  // of a face seen from its side
  constexpr double kCrowded = 5.0;  // mean length of edges [pixel]
  std::vector<Corner> corners;
  corners.reserve(static_cast<std::size_t>(surface.points.rows()));
  for (Eigen::Index p = 0; p < surface.points.rows(); ++p) {
    const Eigen::Vector3d place = surface.points.row(p);
    const Eigen::Vector2d at = kFiner * placement.at(place);
    const double z =
        kFiner * placement.scale * placement.sight.row(2).dot(place);
    corners.push_back(
        {at.x(), at.y(), z, surface.colour ? 0.0 : surface.stress[p]});
  }
  const auto corner = [&corners](int point) -> const Corner& {
    return corners[static_cast<std::size_t>(point)];
  };
  for (const auto& [a, b, c] : surface.triangles) {
    const Corner &p = corner(a), &q = corner(b), &r = corner(c);
    const Eigen::Vector3d normal =
        Eigen::Vector3d(q.x - p.x, q.y - p.y, q.z - p.z)
            .cross(Eigen::Vector3d(r.x - p.x, r.y - p.y, r.z - p.z));
    const double facing =
        normal.norm() > 0.0 ? std::abs(normal.z()) / normal.norm() : 1.0;
    fill(p, q, r, kDarkest + (1.0 - kDarkest) * facing, largest,
         surface.colour ? &*surface.colour : nullptr);
  }
  ++drawn_;
  const auto edges = mesh_edges(surface);
  double length = 0.0;
  for (const auto& [a, b] : edges) {
    length += std::hypot(corner(a).x - corner(b).x, corner(a).y - corner(b).y);
  }
  if (!surface.colour &&
      length < kFiner * kCrowded * static_cast<double>(edges.size())) {
    return;
  }
  for (const auto& [a, b] : edges) line(corner(a), corner(b), 2.0 * kFiner);
}

void Raster::fill(const Corner& a, const Corner& b, const Corner& c,
                  double light, double largest, const Colour* plain) {
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0.0) return;
  const auto first = [](double low) {
    return std::max(0, static_cast<int>(std::ceil(low - 0.5)));
  };
  const auto last = [](double high, int size) {
    return std::min(size - 1, static_cast<int>(std::floor(high - 0.5)));
  };
  const int left = first(std::min({a.x, b.x, c.x}));
  const int right = last(std::max({a.x, b.x, c.x}), width_);
  const int bottom = last(std::max({a.y, b.y, c.y}), height_);
  for (int y = first(std::min({a.y, b.y, c.y})); y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
      const double q = (px * (c.y - a.y) - (c.x - a.x) * py) / area;
      const double r = ((b.x - a.x) * py - px * (b.y - a.y)) / area;
      constexpr double kSeam = -1e-9;
      if (q < kSeam || r < kSeam || q + r > 1.0 - kSeam) continue;
      const auto at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
          static_cast<std::size_t>(x);
      const auto z =
          static_cast<float>(a.z + q * (b.z - a.z) + r * (c.z - a.z));
      if (z <= depth_[at]) continue;
      depth_[at] = z;
      front_[at] = drawn_;
      const double stress =
          a.stress + q * (b.stress - a.stress) + r * (c.stress - a.stress);
      const Colour& colour =
          plain != nullptr ? *plain
                           : shade(largest > 0.0 ? stress / largest : 0.0);
      for (std::size_t k = 0; k < 3; ++k) {
        pixels_[3 * at + k] = static_cast<std::uint8_t>(light * colour[k]);
      }
    }
  }
}

void Raster::line(const Corner& a, const Corner& b, double bias) {
  constexpr double kThrough = 0.6;  // of the light below it
  const double length = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
  const int steps = static_cast<int>(std::ceil(length));
  for (int k = 0; k < steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const int x = static_cast<int>(std::floor(a.x + share * (b.x - a.x)));
    const int y = static_cast<int>(std::floor(a.y + share * (b.y - a.y)));
    if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
    const auto at =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
        static_cast<std::size_t>(x);
    if (a.z + share * (b.z - a.z) + bias < depth_[at]) continue;
    for (std::size_t c = 3 * at; c < 3 * at + 3; ++c) {
      pixels_[c] = static_cast<std::uint8_t>(kThrough * pixels_[c]);
    }
  }
}

int Raster::front(int x, int y) const {
  return front_[static_cast<std::size_t>(kFiner * y) *
                    static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(kFiner * x)];
}

std::vector<std::uint8_t> Raster::rgb() const {
  const int width = width_ / kFiner, height = height_ / kFiner;
  std::vector<std::uint8_t> coarse;
  coarse.reserve(pixels_.size() / (kFiner * kFiner));
  const auto row = 3 * static_cast<std::size_t>(width_);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = static_cast<std::size_t>(kFiner * y) * row +
                               3 * static_cast<std::size_t>(kFiner * x) + c;
        const int sum = pixels_[at] + pixels_[at + 3] + pixels_[at + row] +
                        pixels_[at + row + 3];
        coarse.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return coarse;
}

std::string Raster::png() const {
  return png_of(rgb(), width_ / kFiner, height_ / kFiner);
}

}  // namespace clevis::report
