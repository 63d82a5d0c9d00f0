#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/zone_trace.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// Consistent nodal loads on one group of the surface.
struct SurfaceLoads {
  std::vector<int> nodes;  ///< of the group, sorted
  /// Row dim*k + d: component d at nodes[k], a column per instant [N].
  Eigen::MatrixXd values;
};

/// Loads of a seat: bearing or linear traction at the quadrature points of its
/// group, plus the correction that makes the discrete resultant the wrench to
/// round-off.
/// @throws Error M003 if the mesh lacks a group, L002 if a bearing seat's
///   group is no cylinder, or would have to pull.
template <int dim>
SurfaceLoads seat_loads(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, std::size_t seat,
                        const std::string& part_name);

/// The wall that a slide's counterpart travels over, made once for loads that
/// are asked for again and again.
template <int dim>
class SlideWall {
 public:
  /// @param seat  that slides. @param discretization  outlives the object.
  /// @throws Error M003.
  SlideWall(const Discretization<dim>& discretization, const loads::Seat& seat,
            const std::string& part_name);

  /// Of a seat on this wall [N]. @throws Error L002, L007.
  SurfaceLoads of(const loads::LoadHistory& history, std::size_t seat) const;

 private:
  std::string part_name_;
  std::vector<int> groups_, nodes_;
  std::unique_ptr<FaceTables<dim>> tables_;
  std::unique_ptr<const WallFaces<dim>> faces_;
};

/// Loads of all seats, then of all loaded faces.
template <int dim>
std::vector<SurfaceLoads> surface_loads(
    const Discretization<dim>& discretization,
    const loads::LoadHistory& history, const std::string& part_name);

}  // namespace clevis::elasticity
