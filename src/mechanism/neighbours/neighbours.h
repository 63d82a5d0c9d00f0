#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "mechanism/element_base/acting_element.h"

namespace clevis::mechanism {

/// A joint of a body, what a drive holds of it, or where a force element acts
/// on it or holds it.
struct NeighbourPlace {
  int joint{};
  bool is_drive{};
  int element = -1;  ///< then neither of these

  bool operator==(const NeighbourPlace&) const = default;
};

/// Rows of constraints at an instant, of the unknowns of ConstraintSystem about
/// centres of mass: those of the body with its neighbours, and those among
/// neighbours.
struct NeighbourRows {
  Configuration x;
  std::vector<NeighbourPlace> places;
  std::vector<std::size_t> place_of;  ///< of each row of the body
  Eigen::MatrixXd body;               ///< rows × 6
  Eigen::MatrixXd there;  ///< the same rows, of the neighbours' unknowns
  Eigen::MatrixXd free;   ///< orthonormal motions that rows among them leave
};

/// The bodies that joints, couplings and force elements join to one, rigid and
/// held by their own joints, couplings and drives. The ground joins none.
class Neighbours {
 public:
  /// Of more than a hundred bodies those nearest by these.
  /// @param definition  outlives the object.
  Neighbours(const MechanismDefinition& definition, BodyIndex body);
  Neighbours(const Neighbours&) = delete;

  const MechanismDefinition& definition() const { return definition_; }
  /// Every body's M is its centre of mass.
  const SolvingFrame& frame() const { return frame_; }
  int slot() const { return slot_; }                        ///< of the body
  const std::vector<int>& slots() const { return slots_; }  ///< of neighbours
  NeighbourRows rows(const Instant& instant) const;
  /// Force elements, placed; null: it holds nothing.
  const std::vector<std::unique_ptr<ActingElement>>& elements() const {
    return elements_;
  }
  /// Whether an element acts on the body itself.
  bool acts_on_body(const ActingElement& element) const {
    return element.line.a == slot_ || element.line.b == slot_;
  }
  /// Leaves an element out that lets go meanwhile.
  void leave_out(std::size_t element) { elements_[element] = nullptr; }
  /// Lets an element hold its line as a joint would: friction that sticks.
  void hold_along(std::size_t element) { held_lines_.push_back(element); }
  /// Of the neighbours about their centres, with rotors that turn between them,
  /// in unknowns of ConstraintSystem [kg].
  Eigen::MatrixXd masses(const Configuration& x) const;
  /// Adds an action on a neighbour to a row of their unknowns; on another body
  /// it does nothing.
  /// @param action  about the neighbour's M, in P [N], [N m].
  void add_action(int slot, const SpatialForce& action,
                  Eigen::Ref<Eigen::VectorXd> row) const;

 private:
  Eigen::VectorXd row_of_teeth(const CouplingModel& coupling,
                               const Configuration& x,
                               const std::vector<PlacedJoint>& placed,
                               double effort) const;
  NeighbourPlace place_of(const ConstraintSystem::Row& row,
                          bool is_drive) const;

  const MechanismDefinition& definition_;
  SolvingFrame frame_;
  ConstraintSystem system_;
  int slot_;
  std::vector<std::unique_ptr<ActingElement>> elements_;
  std::vector<std::size_t> held_lines_;  ///< of elements
  std::vector<int> slots_;
};

/// Of the bodies at an instant, referred to the frame's points M [m], [rad].
Configuration configuration_at(const SolvingFrame& frame,
                               const Instant& instant);

/// Of an effort of 1 along an element's line, in P. @pre it has one.
PlacedJoint::Levers levers_of(const ActingElement& element,
                              const Configuration& x);

/// The same of all bodies, in unknowns of a system. @pre it has one.
Eigen::VectorXd row_along(const ActingElement& element, const Configuration& x,
                          const ConstraintSystem& system);

/// R with R Rᵀ a stiffness [N/m], damping or inertia; of what pushes on
/// nothing.
Eigen::MatrixXd root_of(const Eigen::MatrixXd& matrix);

}  // namespace clevis::mechanism
