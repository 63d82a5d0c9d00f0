#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace clevis::cad {

enum class SurfaceKind { kPlane, kCylinder, kCone, kSphere, kTorus, kOther };

/// As tables and JSON call them.
inline constexpr std::array<std::pair<std::string_view, SurfaceKind>, 6>
    kSurfaceNames{{{"plane", SurfaceKind::kPlane},
                   {"cylinder", SurfaceKind::kCylinder},
                   {"cone", SurfaceKind::kCone},
                   {"sphere", SurfaceKind::kSphere},
                   {"torus", SurfaceKind::kTorus},
                   {"other", SurfaceKind::kOther}}};

/// A face of a solid, in the part's frame.
struct Face {
  int number{};  ///< 1, 2, … in the order of the file
  SurfaceKind kind = SurfaceKind::kOther;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of its area [m]
  double area{};                                     ///< [m²]
  /// Out of the part, where it is met half-way along both parameters.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  /// Of surfaces of revolution: a point of the axis [m] and its direction.
  Eigen::Vector3d axis_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  double radius{};  ///< of cylinder, sphere, the torus' pipe; cone: middle [m]
  bool hollow{};    ///< the part lies outside: a bore, a concave fillet
  double angle{};   ///< about the axis [rad], a full turn: 2π
  double low{}, high{};  ///< along the axis from its point [m]
  /// Of cylinders: ∫ n nᵀ dA of their normals [m²].
  Eigen::Matrix3d normal_square = Eigen::Matrix3d::Zero();
  std::string label;  ///< of a STEP file's entity; empty: none, or "NONE"
  std::vector<int> neighbours;  ///< numbers of the faces behind its edges
};

/// Triangles near a face, for pictures; their corners turn left about the
/// outward normal.
struct Facets {
  std::vector<Eigen::Vector3d> points;  ///< [m]
  std::vector<std::array<int, 3>> triangles;
};

/// What a CAD file holds, once it is known to be one sound solid.
struct Solid {
  std::string unit;  ///< that the file gives, e.g. "INCH"; empty: none
  double volume{};   ///< [m³]
  Eigen::Vector3d low = Eigen::Vector3d::Zero();   ///< of its box [m]
  Eigen::Vector3d high = Eigen::Vector3d::Zero();  ///< [m]
  std::vector<Face> faces;
  /// Of each point that was asked about, its distance from each face [m].
  std::vector<std::vector<double>> distances;
  std::vector<Facets> facets;  ///< of each face; empty: not asked for
};

}  // namespace clevis::cad
