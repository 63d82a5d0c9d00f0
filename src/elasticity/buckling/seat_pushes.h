#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/buckling/pin_hold.h"
#include "elasticity/fe_space/discretization.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// What following forces of a part's seats add to what its stresses do: forces
/// on a seat in proportion to its surface's mean displacement, by instant.
class SeatPushes {
 public:
  /// @param part_name  for messages. @throws Error M003.
  SeatPushes(const Discretization<3>& discretization,
             const loads::LoadHistory& history, const std::string& part_name);

  bool is_empty() const { return seats_.empty(); }
  /// Adds the forces [N] on displacements u (dofs × columns [m]) of an instant.
  void add(const Eigen::MatrixXd& u, Eigen::Index instant,
           Eigen::MatrixXd& forces) const;
  /// Mean displacements of the seats, 3 per seat × columns [m].
  Eigen::MatrixXd means(const Eigen::MatrixXd& u) const;
  /// Adds meansᵀ (gains) means to a form, columns × columns [J].
  void add_form(const Eigen::MatrixXd& means, Eigen::Index instant,
                Eigen::MatrixXd& form) const;

 private:
  struct Push {
    std::size_t seat;  ///< of seats_
    Eigen::Matrix3d gain;
  };
  std::vector<NodeFunctionals> seats_;  ///< mean displacements, three each
  std::vector<std::vector<Push>> of_instant_;
};

}  // namespace clevis::elasticity
