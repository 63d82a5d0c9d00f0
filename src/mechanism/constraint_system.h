#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/definition.h"
#include "mechanism/joint_model.h"

namespace clevis::mechanism {

/// Positions of all bodies by slot; slot 0 is ground.
using Configuration = std::vector<BodyPlacement>;

/// A mechanism in the frame P in which it is solved: for planar ones z is the
/// plane's normal. Each body is referred to M, the mean of its joints.
struct SolvingFrame {
  explicit SolvingFrame(const MechanismDefinition& definition);

  bool planar{};
  Eigen::Matrix3d R_WP = Eigen::Matrix3d::Identity();
  /// Lengths of the links' order [m]: turns are measured as turn × length.
  double length{};
  std::vector<Eigen::Vector3d> p_LM;  ///< by body [m]
  std::vector<JointModel> joints;
  Configuration placement;  ///< as the user gave it, out of plane closed
};

/// The constraint equations c(x, t) = 0 of a mechanism for some motions of
/// its bodies: the joints' rows, then one row per drive.
///
/// Unknowns of a body: displacement of M and length × turn, so that rows,
/// columns and multipliers do not depend on the units or the size.
class ConstraintSystem {
 public:
  /// @param with_drives  kNone leaves the drives' rows out.
  enum class Drives { kNone, kAll };
  ConstraintSystem(const SolvingFrame& frame,
                   const std::vector<DriveDefinition>& drives, Motions motions,
                   Drives with_drives);

  int rows() const { return static_cast<int>(rows_.size()); }
  int columns() const { return columns_; }
  int joint_rows() const { return joint_rows_; }
  Motions motions() const { return motions_; }

  /// A row: which joint, and which motion of it. Drives come last.
  struct Row {
    int joint{};
    JointRow row{};
  };
  const std::vector<Row>& row_list() const { return rows_; }

  std::vector<PlacedJoint> place(const Configuration& x) const;

  /// c [m], turns times length; `targets`: drives' coordinates.
  Eigen::VectorXd residual(const std::vector<PlacedJoint>& placed,
                           const Eigen::VectorXd& targets) const;
  Eigen::MatrixXd jacobian(const std::vector<PlacedJoint>& placed) const;
  /// Part of the second derivative of c that velocities cause.
  Eigen::VectorXd bias(const std::vector<PlacedJoint>& placed,
                       const std::vector<Twist>& twists) const;

  /// Unknowns ↔ twists by slot.
  std::vector<Twist> twists(const Eigen::VectorXd& unknowns) const;
  /// Wrenches about M by slot → right-hand side of Jᵀλ = wrench.
  Eigen::VectorXd wrench_vector(const std::vector<Twist>& wrenches) const;
  /// Multiplier of a row in N or N m from the scaled one.
  double multiplier(const Row& row, double scaled) const;

  void move(Configuration& x, const Eigen::VectorXd& unknowns) const;
  /// Largest displacement between two configurations: |Δp| + length |Δturn|.
  double distance(const Configuration& x, const Configuration& y) const;

  double scale(const JointRow& row) const {
    return row.kind == JointRow::Kind::kRotation ? length_ : 1.0;
  }

 private:
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
