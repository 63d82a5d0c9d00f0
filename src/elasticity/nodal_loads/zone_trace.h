#pragma once

#include <deque>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/face_map.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// Points p with normal · p <= offset [m].
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset{};
};

/// A zone of a seat as half-spaces of L, as many as it has edges.
std::vector<HalfSpace> bounds_of(const loads::Seat& seat,
                                 const loads::ContactZone& zone);

/// Faces of some groups, with what serves every zone on them.
template <int dim>
struct WallFaces {
  struct Face {
    int cell{};
    FaceMap<dim> map;
    Eigen::Matrix3Xd points;  ///< that tell how it lies to a plane [m]
    const FaceTable<dim>* whole;
    WeightedSurface surface;  ///< of the whole
  };

  const Discretization<dim>* discretization;
  std::map<int, FaceBasis<dim>> bases;  ///< per local face
  Quadrature<dim - 1> cut_rule;  ///< of a piece of a face that an edge crosses
  std::vector<Face> faces;

  /// @param groups  of the discretisation, which outlives this, as the tables.
  WallFaces(const Discretization<dim>& of, const std::vector<int>& groups,
            FaceTables<dim>& tables);
  WallFaces(const WallFaces&) = delete;
  WallFaces& operator=(const WallFaces&) = delete;
};

/// Quadrature of the part of some faces that lies within half-spaces, with the
/// trace of the basis: faces that an edge crosses are cut along it, so that a
/// load that ends there is integrated as it is.
template <int dim>
class ZoneTrace {
 public:
  /// @param wall  outlives the trace.
  ZoneTrace(const WallFaces<dim>& wall, const std::vector<HalfSpace>& bounds);

  ZoneTrace(const ZoneTrace&) = delete;
  ZoneTrace& operator=(const ZoneTrace&) = delete;

  /// Without points where nothing lies within.
  const GroupTrace& trace() const { return trace_; }

 private:
  std::deque<Eigen::MatrixXd> cut_;  ///< basis on faces that an edge crosses
  GroupTrace trace_;
};

}  // namespace clevis::elasticity
