#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/dynamic_state/mechanism_state.h"
#include "mechanism/forces/force_model.h"
#include "mechanism/forces/given_efforts.h"
#include "mechanism/mass_matrix/body_inertias.h"
#include "mechanism/mass_matrix/constrained_mass.h"

namespace clevis::mechanism {

/// The constraints of a motion by forces and its mass matrix: rows of joints,
/// couplings and drives, then one of each force element that sticks or that
/// turns a rotor. The rotor of a motor adds an unknown, its speed at the joint
/// times the length, and the row that ties it to the joint; it is no state.
class MotionConstraints {
 public:
  using Index = Eigen::Index;

  /// @param frame, system, forces  outlive this.
  MotionConstraints(const SolvingFrame& frame, const ConstraintSystem& system,
                    const ForceModel& forces, const BodyInertias& inertias);

  Index columns() const { return columns_; }  ///< bodies' unknowns, rotors'
  bool has_rotors() const { return columns_ > system_.columns(); }
  /// Rows of the last factor(): those of the system, then of force elements.
  int rows() const { return rows_; }
  /// Rows there may be at most.
  Index most_rows() const { return J_.rows(); }
  /// Scale of the row that element k brings: 1, or the length of angles [m].
  double row_scale(std::size_t k) const {
    return forces_.element(k).row.is_angle() ? frame_.length : 1.0;
  }
  bool turns_rotor(std::size_t k) const { return rotors_[k] >= 0; }
  /// Calls f(k, row) for each element k that brings a row.
  template <typename Function>
  void for_each_element_row(Function f) const {
    int row = system_.rows();
    for (std::size_t k = 0; k < forces_.size(); ++k) {
      if (brings_row(forces_.element(k))) f(k, row++);
    }
  }

  /// Fills the Jacobian and factors the mass matrix with it.
  /// @param state  with its loads.
  void factor(const MechanismState& state);
  /// Fills the rows of joints and drives anew, without factoring them.
  /// @return all rows() of J [1]; those of elements are of the last factor()
  ///   where that was not of a tree.
  auto with_joint_rows(const std::vector<PlacedJoint>& placed) {
    system_.fill_jacobian(placed, J_);
    return J_.topRows(rows_);
  }
  ConstrainedMass& mass() { return mass_; }
  const ConstrainedMass& mass() const { return mass_; }
  /// Orthonormal combinations of rows that vanish: what may be added to the
  /// multipliers. One column each. @pre the last factor() was not of a tree.
  Eigen::MatrixXd open_multipliers() const;

 private:
  bool factor_tree(const std::vector<PlacedJoint>& placed);
  std::vector<TreeLink> links() const;
  void put_rotors();

  const SolvingFrame& frame_;
  const ConstraintSystem& system_;
  const ForceModel& forces_;
  std::vector<Index> rotors_;  ///< by force element: unknown, or −1
  Index columns_;
  ConstrainedMass mass_;
  int rows_;
  Eigen::MatrixXd J_;
};

}  // namespace clevis::mechanism
