#include "mesher/fitted_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Dense>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace clevis::mesher {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr Index kLines = 13;
constexpr double kMillimetre = 1e-3;  // [m]
constexpr double kTolerance = 1e-5;   // of the radius, of the normal

/// Points and unit normals of a surface; column i + kLines j.
struct Grid {
  Matrix3Xd points, normals;  ///< [m]
};

/// Nothing where the surface has no normal.
std::optional<Grid> grid_on(const BRepAdaptor_Surface& surface,
                            const Patch& patch) {
  Grid grid{Matrix3Xd(3, kLines * kLines), Matrix3Xd(3, kLines * kLines)};
  for (Index j = 0; j < kLines; ++j) {
    for (Index i = 0; i < kLines; ++i) {
      gp_Pnt p;
      gp_Vec du, dv;
      surface.D1(std::lerp(patch.u0, patch.u1, double(i) / (kLines - 1)),
                 std::lerp(patch.v0, patch.v1, double(j) / (kLines - 1)), p, du,
                 dv);
      const gp_Vec normal = du.Crossed(dv);
      if (!(normal.Magnitude() > 0.0)) return std::nullopt;
      const Index k = i + kLines * j;
      grid.points.col(k) = kMillimetre * Vector3d(p.X(), p.Y(), p.Z());
      grid.normals.col(k) =
          Vector3d(normal.X(), normal.Y(), normal.Z()).normalized();
    }
  }
  return grid;
}

bool is_plane(const Grid& grid) {
  const Vector3d mean = grid.normals.rowwise().mean().normalized();
  const double size =
      (grid.points.rowwise().maxCoeff() - grid.points.rowwise().minCoeff())
          .norm();
  const Eigen::RowVectorXd height = mean.transpose() * grid.points;
  return (grid.normals.colwise() - mean).colwise().norm().maxCoeff() <
             kTolerance &&
         height.maxCoeff() - height.minCoeff() < kTolerance * size;
}

/// By how far a line of the grid turns [rad].
double turn_along(const Matrix3Xd& normals, const Vector3d& axis, Index first,
                  Index step) {
  double turn = 0.0;
  for (Index k = 0; k + 1 < kLines; ++k) {
    const Vector3d from = normals.col(first + k * step);
    const Vector3d to = normals.col(first + (k + 1) * step);
    turn += std::atan2(axis.dot(from.cross(to)), from.dot(to));
  }
  return std::abs(turn);
}

bool fit_cylinder(const Grid& grid, cad::Face& face) {
  constexpr double kBends = 1e-4;  // mean square of a normal's turn
  // Normals of a cylinder are all across its axis.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(
      grid.normals * grid.normals.transpose() /
      static_cast<double>(grid.normals.cols()));
  if (spread.eigenvalues()[0] > kTolerance * kTolerance ||
      spread.eigenvalues()[1] < kBends) {
    return false;
  }
  const Vector3d axis = spread.eigenvectors().col(0);
  const Matrix3Xd across =
      grid.points - axis * (axis.transpose() * grid.points);
  // p = c + r n, by least squares.
  const Vector3d p = across.rowwise().mean(), n = grid.normals.rowwise().mean();
  const Matrix3Xd dp = across.colwise() - p, dn = grid.normals.colwise() - n;
  const double radius = dp.cwiseProduct(dn).sum() / dn.squaredNorm();
  const Vector3d centre = p - radius * n;
  const Eigen::RowVectorXd away = (across.colwise() - centre).colwise().norm();
  if ((away.array() - std::abs(radius)).abs().maxCoeff() >
      kTolerance * std::abs(radius)) {
    return false;
  }
  const Eigen::RowVectorXd height = axis.transpose() * grid.points;
  face.kind = cad::SurfaceKind::kCylinder;
  face.axis = axis;
  face.axis_point = centre;
  face.radius = std::abs(radius);
  face.low = height.minCoeff() - axis.dot(centre);
  face.high = height.maxCoeff() - axis.dot(centre);
  face.angle = 0.0;
  for (Index k = 0; k < kLines; ++k) {
    face.angle =
        std::max({face.angle, turn_along(grid.normals, axis, k * kLines, 1),
                  turn_along(grid.normals, axis, k, kLines)});
  }
  face.angle = std::min(face.angle, 2.0 * std::numbers::pi);
  return true;
}

}  // namespace

bool is_elementary(const TopoDS_Face& face) {
  return BRepAdaptor_Surface(face).GetType() <= GeomAbs_Torus;
}

bool fit_surface(const BRepAdaptor_Surface& surface, const Patch& patch,
                 cad::Face& face) {
  const auto grid = grid_on(surface, patch);
  if (!grid) return false;
  if (is_plane(*grid)) {
    face.kind = cad::SurfaceKind::kPlane;
    return true;
  }
  return fit_cylinder(*grid, face);
}

}  // namespace clevis::mesher
