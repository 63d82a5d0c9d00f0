#pragma once

#include <Eigen/Core>

#include "loads/history/load_history.h"
#include "part/bore.h"

namespace clevis::loads {

/// Points of a wall in coordinates of their cylinder, whatever presses there.
struct WallPoints {
  /// @param points   p_LQ [m], one a column, on the cylinder.
  /// @param outward  the part's outward unit normals: the pin lies on that
  ///   side, so that a bore (normal towards the axis) and a journal or piston
  ///   (normal away from it) are told apart.
  WallPoints(const part::Bore& bore, const Eigen::Matrix3Xd& points,
             const Eigen::Matrix3Xd& outward);

  Eigen::Matrix3Xd normal, around;  ///< unit; the cylinder's own, outward
  Eigen::RowVectorXd height;        ///< along the axis from the middle [m]
};

/// What there is of a cylinder's wall along its axis: both ears of a fork are
/// one cylinder with a gap. Integrals over the height s from the middle.
struct WallMoments {
  double length{};  ///< ∫ ds [m]
  double first{};   ///< ∫ s ds [m²]
  double second{};  ///< ∫ s² ds [m³]
};

/// Of a wall without gaps.
WallMoments full_wall(const part::Bore& bore);

/// Of the wall that points stand for: where their area is the cylinder's, to
/// 2 %, that of the cylinder without gaps.
/// @param points   p_LQ [m], one a column. @param weights  [m²].
WallMoments wall_of(const part::Bore& bore, const Eigen::Matrix3Xd& points,
                    const Eigen::VectorXd& weights);

/// Traction by which a pin (or a guide) presses on a cylindrical seat.
///
/// The pin carries a line load w(s) = w_0 + w_1 s along the axis (s from the
/// middle), whose resultant is the part of the wrench normal to the axis; at
/// each s the pressure is p = 2|w|/(π r) max(0, cos θ), θ from w(s). The rest
/// of the wrench — force along and moment about the axis — is carried by
/// uniform shear. Left out: friction of the pin, clearance, pin bending.
/// Source: docs/theory.md, "Bearing load".
class BearingTraction {
 public:
  /// @param wrench  on the part, about bore.p_LC, in L.
  BearingTraction(const part::Bore& bore, const Wrench& wrench)
      : BearingTraction(bore, wrench, full_wall(bore)) {}
  /// @param wall  that there is of the cylinder.
  BearingTraction(const part::Bore& bore, const Wrench& wrench,
                  const WallMoments& wall);

  /// Tractions on the part [Pa] at points of the wall. The pin pushes in the
  /// direction of the force: where it fills a bore, it presses on the wall on
  /// the side that the force points at.
  Eigen::Matrix3Xd tractions(const WallPoints& points) const;
  /// The same [Pa]. @param points, outward  as of WallPoints.
  Eigen::Matrix3Xd tractions(const Eigen::Matrix3Xd& points,
                             const Eigen::Matrix3Xd& outward) const {
    return tractions(WallPoints(bore_, points, outward));
  }
  /// The same at one point p_LQ [m], outward a unit normal [Pa].
  Eigen::Vector3d traction(const Eigen::Vector3d& p_LQ,
                           const Eigen::Vector3d& outward_LQ) const;

  /// Line load w at the height of a point, normal to the axis [N/m].
  Eigen::Vector3d line_load(const Eigen::Vector3d& p_LQ) const;

  /// The uniform shear's traction at a point of the wall [Pa].
  Eigen::Vector3d shear(const Eigen::Vector3d& p_LQ) const;

 private:
  part::Bore bore_;
  Eigen::Vector3d line_load_, line_load_slope_;  ///< [N/m], [N/m²]
  double axial_shear_{}, torsional_shear_{};     ///< [Pa]
};

/// Traction t_0 + θ × (p − c) over a group, whose resultant is the wrench.
class LinearTraction {
 public:
  /// @param centroid  c: of the area [m].
  /// @param area      [m²].
  /// @param second_moment  ∫ (|r|² I − r rᵀ) dA, r = p − c [m⁴].
  /// @param wrench    about `about`, in L.
  LinearTraction(const Eigen::Vector3d& centroid, double area,
                 const Eigen::Matrix3d& second_moment, const Wrench& wrench,
                 const Eigen::Vector3d& about);

  /// Traction at a point p_LQ [m], in L [Pa].
  Eigen::Vector3d traction(const Eigen::Vector3d& p_LQ) const;
  /// At many, one a column.
  Eigen::Matrix3Xd tractions(const Eigen::Matrix3Xd& points) const;

 private:
  Eigen::Vector3d centroid_, mean_, slope_;
};

}  // namespace clevis::loads
