#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/nodal_loads/surface_loads.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// Linear functionals of displacements at some nodes.
template <int dim>
struct NodeFunctionals {
  std::vector<Eigen::Index> nodes;  ///< one may stand there twice
  Eigen::MatrixXd rows;             ///< functionals × dim nodes

  /// Of displacements u, dofs × columns [m].
  Eigen::MatrixXd of(const Eigen::MatrixXd& u) const;
  /// Adds amounts of theirs [N], functionals × columns, to forces, dofs ×
  /// columns [N].
  void add(const Eigen::MatrixXd& amounts, Eigen::MatrixXd& forces) const;
};

/// Mean motions of a seat (seat_mean()), as many as rigid ones.
template <int dim>
NodeFunctionals<dim> mean_motions(const SurfaceLoads& of_unit_wrenches);

/// The rigid motion nearest to displacements of some nodes: of the centre, then
/// the rotation about it.
template <int dim>
struct MeanMotion {
  Eigen::Matrix<double, dim, 1> centre;  ///< [m]
  NodeFunctionals<dim> of;
};

/// Seats of a part, and what counterparts touch of them at an instant.
struct TouchedSeats {
  std::vector<loads::Seat> seats;
  std::vector<loads::ContactZone> zones;  ///< one per seat
};

/// Mean motions of a part's groups, each worked out when it is asked for first.
template <int dim>
class MeanMotions {
 public:
  /// @param discretization  outlives the object.
  explicit MeanMotions(const Discretization<dim>& discretization);

  bool has_faces(const std::string& group) const;
  /// Largest extent of the nodes [m].
  double size() const { return size_; }
  /// Rigid motions about the nodes' mean: translations, then rotations by 1
  /// over size(); dofs × motions.
  const Eigen::MatrixXd& rigid() const { return rigid_; }

  /// By area of a group that has faces.
  const MeanMotion<dim>& of_group(const std::string& group);
  /// By volume of all nodes.
  const MeanMotion<dim>& of_part();
  /// Of what is touched of a slide's wall, about its middle. On a plane mesh
  /// the zone reaches from lid to lid.
  /// @throws Error M003.
  MeanMotion<dim> of_touched(const TouchedSeats& touched, std::size_t seat,
                             const std::string& part_name);

 private:
  MeanMotion<dim> mean_motion(const Eigen::VectorXd& weights) const;

  const Discretization<dim>& discretization_;
  Eigen::Matrix<double, dim, Eigen::Dynamic> positions_;
  double size_;
  Eigen::MatrixXd rigid_;
  std::map<std::string, MeanMotion<dim>> of_groups_;
  /// By the seat's groups.
  std::map<std::pair<std::string, std::string>, SlideWall<dim>> walls_;
  std::optional<MeanMotion<dim>> of_part_;
};

}  // namespace clevis::elasticity
