#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"
#include "mechanism/joints/joint_model.h"

namespace clevis::mechanism {

/// The constraint equations c(x, t) = 0 of a mechanism for some motions of
/// its bodies: the joints' rows, one row per coupling, one per drive.
///
/// Unknowns of a body: displacement of M and length × turn [m], so that rows,
/// columns and multipliers do not depend on the units or the size. Multipliers
/// are forces, moments over the length [N]; the Jacobian is of pure numbers.
class ConstraintSystem {
 public:
  /// @param with_drives  kNone leaves the drives' rows out.
  enum class Drives { kNone, kAll };
  ConstraintSystem(const SolvingFrame& frame,
                   const std::vector<DriveDefinition>& drives, Motions motions,
                   Drives with_drives);

  int rows() const { return static_cast<int>(rows_.size()); }
  int columns() const { return columns_; }
  /// Rows of joints and couplings; those of drives follow.
  int joint_rows() const { return joint_rows_; }
  Motions motions() const { return motions_; }

  /// A row: which joint, and which motion of it; of a coupling the first.
  struct Row {
    int joint{};
    JointRow row{};
    int coupling = -1;  ///< index, or −1
  };
  const std::vector<Row>& row_list() const { return rows_; }

  std::vector<PlacedJoint> place(const Configuration& x) const;

  /// c [m], turns times length; `targets`: drives' coordinates.
  Eigen::VectorXd residual(const std::vector<PlacedJoint>& placed,
                           const Eigen::VectorXd& targets) const;
  Eigen::MatrixXd jacobian(const std::vector<PlacedJoint>& placed) const;
  /// Part of the second derivative of c that velocities cause [m/s²].
  Eigen::VectorXd bias(const std::vector<PlacedJoint>& placed,
                       const std::vector<Twist>& twists) const;

  /// The same into storage of the right size, without allocation.
  void place(const Configuration& x, std::vector<PlacedJoint>& placed) const;
  void residual(const std::vector<PlacedJoint>& placed,
                const Eigen::VectorXd& targets, Eigen::VectorXd& c) const;
  /// @param J  its first rows are filled.
  void fill_jacobian(const std::vector<PlacedJoint>& placed,
                     Eigen::MatrixXd& J) const;
  void bias(const std::vector<PlacedJoint>& placed,
            const std::vector<Twist>& twists, Eigen::VectorXd& bias) const;

  /// Adds factor × levers of a line between two slots to a row of J.
  void add_levers(Eigen::MatrixXd& J, int row, int slot_a, int slot_b,
                  const PlacedJoint::Levers& levers, double factor) const;

  /// Unknowns ↔ twists by slot.
  std::vector<Twist> twists(const Eigen::VectorXd& unknowns) const;
  /// Wrenches about M by slot → right-hand side of Jᵀλ = wrench [N].
  Eigen::VectorXd wrench_vector(
      const std::vector<SpatialForce>& wrenches) const;
  /// Multiplier of a row in N or N m from the scaled one.
  double multiplier(const Row& row, double scaled) const;

  void move(Configuration& x, const Eigen::VectorXd& unknowns) const;
  /// Largest displacement between two configurations: |Δp| + length |Δturn|
  /// [m].
  double distance(const Configuration& x, const Configuration& y) const;
  /// The displacement that moves x to y, of these motions [m].
  Eigen::VectorXd difference(const Configuration& x,
                             const Configuration& y) const;

  double scale(const JointRow& row) const {
    return row.is_angle() ? length_ : 1.0;
  }
  double scale(const Row& row) const {
    return row.coupling < 0 ? scale(row.row)
                            : frame_->couplings[coupling(row)].scale;
  }

 private:
  static std::size_t coupling(const Row& row) {
    return static_cast<std::size_t>(row.coupling);
  }
  const SolvingFrame* frame_;
  Motions motions_;
  std::span<const int> components_;
  double length_;
  int columns_{}, joint_rows_{};
  std::vector<Row> rows_;
};

/// Largest gap of the joints [m] in rows of a residual, turns × length.
double largest_gap(const Eigen::VectorXd& residual);

}  // namespace clevis::mechanism
