#include "mesh/derived/revolution.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/derived/plate.h"
#include "mesh/reading/mesh_reader.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTurn = 2.0 * std::numbers::pi;

struct Axis {
  Vector3d origin;
  Matrix3d axes;
};

/// A frame on an axis; its angles count from a coordinate direction where the
/// axis is one too.
Axis axis_along(const Vector3d& origin, const Vector3d& direction) {
  constexpr double kSame = 1e-12;
  for (int d = 0; d < 3; ++d) {
    if (std::abs(direction[d]) < 1.0 - kSame) continue;
    Matrix3d axes;
    for (int k = 0; k < 3; ++k) axes.col(k) = Vector3d::Unit((d + k) % 3);
    return {origin - origin[d] * Vector3d::Unit(d), axes};
  }
  Matrix3d axes;
  axes.col(0) = direction.normalized();
  axes.col(1) = axes.col(0).unitOrthogonal();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return {origin, axes};
}

std::vector<Axis> candidates(const PartMesh<3>& mesh) {
  std::vector<Axis> result;
  for (const auto& group : mesh.groups) {
    if (!group.cylinder) continue;
    result.push_back(axis_along(group.cylinder->p_LC, group.cylinder->axis_L));
  }
  Eigen::AlignedBox3d box;
  for (const auto& vertex : mesh.vertices) box.extend(vertex);
  for (const Vector3d& origin :
       std::array<Vector3d, 2>{Vector3d::Zero(), box.center()}) {
    for (int d = 0; d < 3; ++d) {
      result.push_back(axis_along(origin, Vector3d::Unit(d)));
    }
  }
  return result;
}

/// Coordinate along the axis, radius and angle of points in L.
Eigen::Matrix3Xd cylindrical(const Axis& axis, const Eigen::Matrix3Xd& points) {
  Eigen::Matrix3Xd result =
      axis.axes.transpose() * (points.colwise() - axis.origin);
  for (auto p : result.colwise()) {
    p = Vector3d(p.x(), std::hypot(p.y(), p.z()), std::atan2(p.z(), p.y()));
  }
  return result;
}

/// An angle as its multiple of 2π nearest to zero leaves it.
double near_zero(double angle) {
  return std::remainder(angle, kTurn);
}

/// A mesh about an axis rolled out: (x, r, R θ) with θ from 0 to 2π, the cut
/// at both ends. Cells must reach from one meridian plane to the next.
class Unrolled {
 public:
  Unrolled(const PartMesh<3>& mesh, const Axis& axis)
      : mesh_(mesh), axis_(axis), tolerance_(1e-8 * size_of(mesh)) {
    Eigen::Matrix3Xd vertices(3, Index(mesh.vertices.size()));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      vertices.col(Index(v)) = mesh.vertices[v];
    }
    radius_ = cylindrical(axis, vertices).row(1).maxCoeff();
    flat_.degree = mesh.degree;
    flat_.groups = mesh.groups;
    flat_.boundary = mesh.boundary;
  }

  /// Nothing if the cells stand in no closed rings.
  std::optional<PartMesh<3>> make() {
    for (std::size_t cell = 0; cell < mesh_.cells.size(); ++cell) {
      if (!add(cell)) return std::nullopt;
    }
    if (at_start_ != at_end_ || at_start_.empty()) return std::nullopt;
    return std::move(flat_);
  }

 private:
  Index index(int along, int i, int a, int b) const {
    std::array<int, 3> at{};
    at[std::size_t(along)] = i;
    at[std::size_t((along + 1) % 3)] = a;
    at[std::size_t((along + 2) % 3)] = b;
    const int n = mesh_.degree + 1;
    return at[0] + n * (at[1] + Index(n) * at[2]);
  }

  /// Whether direction `along` of a cell runs round the axis; `span` its angle.
  bool runs_round(const Eigen::Matrix3Xd& points, int along,
                  double& span) const {
    const int k = mesh_.degree;
    const double start = points(2, index(along, 0, 0, 0));
    span = near_zero(points(2, index(along, k, 0, 0)) - start);
    if (std::abs(span) * radius_ < 10.0 * tolerance_) return false;
    const double sagitta = radius_ * (1.0 - std::cos(0.5 * span));
    for (int b = 0; b <= k; ++b) {
      for (int a = 0; a <= k; ++a) {
        const Vector3d foot = points.col(index(along, 0, a, b));
        for (int i = 0; i <= k; ++i) {
          // Inside a cell its nodes may cut the corner.
          const double allowed =
              tolerance_ + (i == 0 || i == k ? 0.0 : sagitta);
          const double want = i == 0 ? start : start + span;
          const Vector3d p = points.col(index(along, i, a, b));
          if ((p - foot).head<2>().norm() > allowed) return false;
          if (i != 0 && i != k) continue;
          if (std::abs(near_zero(p.z() - want)) * p.y() > tolerance_) {
            return false;
          }
        }
      }
    }
    return true;
  }

  bool add(std::size_t cell) {
    const auto points = cylindrical(axis_, mesh_.cell_points[cell]);
    double span = 0.0;
    int along = 0;
    while (along < 3 && !runs_round(points, along, span)) ++along;
    if (along == 3) return false;
    const int k = mesh_.degree;
    const double first = points(2, index(along, 0, 0, 0));
    const double start = span > 0.0 ? first : first + span;
    if (cell == 0) cut_ = start;
    const double small = tolerance_ / radius_;
    double from = near_zero(start - cut_);
    if (from < -small) from += kTurn;
    if (from + std::abs(span) > kTurn + small) return false;
    add_points(points, along, span > 0.0 ? from : from - span, span);
    const bool starts = std::abs(from) <= small;
    const bool ends = std::abs(from + std::abs(span) - kTurn) <= small;
    auto& corners = flat_.cells.emplace_back();
    for (int v = 0; v < 8; ++v) {
      const bool high = (((v >> along) & 1) == 1) == (span > 0.0);
      const unsigned old = mesh_.cells[cell][std::size_t(v)];
      if (starts && !high) at_start_.insert(old);
      if (ends && high) at_end_.insert(old);
      corners.push_back(vertex(old, ends && high, v, k));
    }
    return true;
  }

  void add_points(const Eigen::Matrix3Xd& points, int along, double start,
                  double span) {
    const int k = mesh_.degree;
    const Eigen::VectorXd nodes = gauss_lobatto(k);
    auto& flat = flat_.cell_points.emplace_back(points);
    for (int b = 0; b <= k; ++b) {
      for (int a = 0; a <= k; ++a) {
        const Vector3d foot = points.col(index(along, 0, a, b));
        for (int i = 0; i <= k; ++i) {
          flat.col(index(along, i, a, b)) =
              Vector3d(foot.x(), foot.y(), radius_ * (start + span * nodes[i]));
        }
      }
    }
  }

  /// Number of a corner of the last cell, on the far side of the cut or not.
  unsigned vertex(unsigned old, bool beyond, int corner, int k) {
    const auto [entry, is_new] = number_.emplace(
        std::pair(old, beyond), unsigned(flat_.vertices.size()));
    if (is_new) {
      const int n = k + 1;
      const Index at = k * ((corner & 1) + Index(n) * ((corner >> 1) & 1) +
                            Index(n) * n * (corner >> 2));
      flat_.vertices.push_back(flat_.cell_points.back().col(at));
    }
    return entry->second;
  }

  const PartMesh<3>& mesh_;
  Axis axis_;
  double tolerance_, radius_{}, cut_{};
  PartMesh<3> flat_;
  std::map<std::pair<unsigned, bool>, unsigned> number_;
  std::set<unsigned> at_start_, at_end_;
};

}  // namespace

Vector3d Revolution::at(const Eigen::Vector2d& meridian_point,
                        double angle) const {
  return origin + axes * Vector3d(meridian_point.x(),
                                  meridian_point.y() * std::cos(angle),
                                  meridian_point.y() * std::sin(angle));
}

std::optional<Revolution> find_revolution(const PartMesh<3>& mesh) {
  // A mesh of degree 1 is faceted: a prism, not round.
  if (mesh.shape != CellShape::kTensor || mesh.cells.empty() ||
      mesh.degree < 2) {
    return std::nullopt;
  }
  for (const Axis& axis : candidates(mesh)) {
    const auto flat = Unrolled(mesh, axis).make();
    if (!flat) continue;
    // Rolled out, rings are columns from 0 to 2π.
    auto meridian = plate_mid_plane(*flat);
    if (!meridian) continue;
    meridian->thickness = 1.0;
    meridian->mid_plane_z = 0.0;
    return Revolution{std::move(*meridian), axis.origin, axis.axes};
  }
  return std::nullopt;
}

}  // namespace clevis::mesh
