#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/holds/mean_motions.h"
#include "elasticity/nodal_loads/surface_loads.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// What loads that follow a part's seats (loads::SeatGains) add to what its
/// stresses do: forces and moments on seats in proportion to the mean motions
/// of their surfaces, of a slide of what is touched then: between eight places
/// along its way linear.
class SeatPushes {
 public:
  /// @param surfaces  as of surface_loads(), seats first.
  /// @param part_name  for messages. @throws Error M003.
  SeatPushes(const Discretization<3>& discretization,
             const loads::LoadHistory& history,
             const std::vector<SurfaceLoads>& surfaces,
             const std::string& part_name);

  bool is_empty() const { return seats_.empty(); }
  /// Of an instant, motions × motions, symmetric [N/m], [N], [N m].
  Eigen::MatrixXd gain(Eigen::Index instant) const;
  /// Adds the forces [N] on displacements u (dofs × columns [m]).
  void add(const Eigen::MatrixXd& u, const Eigen::MatrixXd& gain,
           Eigen::MatrixXd& forces) const;
  /// Of a unit of each motion, dofs × motions.
  Eigen::MatrixXd unit_forces() const;
  /// Mean motions of the seats at their places, six each × columns [m], [rad].
  Eigen::MatrixXd motions(const Eigen::MatrixXd& u) const;

 private:
  void add_forces(const Eigen::MatrixXd& pushing,
                  Eigen::MatrixXd& forces) const;

  struct Push {
    std::vector<Eigen::Index> motions;  ///< of motions()
    Eigen::MatrixXd gain;
  };
  Eigen::Index dofs_;
  std::vector<NodeFunctionals<3>> seats_;  ///< mean motions, by place
  std::vector<Push> of_instant_;
};

}  // namespace clevis::elasticity
