#pragma once

#include <deque>
#include <vector>

#include <Eigen/Core>

#include "elasticity/group_trace.h"
#include "loads/load_history.h"

namespace clevis::elasticity {

/// Points p with normal · p <= offset [m].
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset{};
};

/// A zone of a seat as half-spaces of L, as many as it has edges.
std::vector<HalfSpace> bounds_of(const loads::Seat& seat,
                                 const loads::ContactZone& zone);

/// Faces of some groups, with points of each that tell how it lies to a plane.
template <int dim>
struct WallFaces {
  const Discretization<dim>* discretization;
  std::vector<GroupFace> faces;
  std::vector<Eigen::Matrix3Xd> points;  ///< per face [m]

  /// @param groups  of the discretisation, which outlives this.
  WallFaces(const Discretization<dim>& of, const std::vector<int>& groups);
};

/// Quadrature of the part of some faces that lies within half-spaces, with the
/// trace of the basis: faces that an edge crosses are cut along it, so that a
/// load that ends there is integrated as it is.
template <int dim>
class ZoneTrace {
 public:
  /// @param tables  of faces that lie within; outlives the trace.
  ZoneTrace(const WallFaces<dim>& wall, const std::vector<HalfSpace>& bounds,
            FaceTables<dim>& tables);

  ZoneTrace(const ZoneTrace&) = delete;
  ZoneTrace& operator=(const ZoneTrace&) = delete;

  /// Without points where nothing lies within.
  const GroupTrace& trace() const { return trace_; }

 private:
  std::deque<FaceTable<dim>> cut_;  ///< of faces that an edge crosses
  GroupTrace trace_;
};

}  // namespace clevis::elasticity
