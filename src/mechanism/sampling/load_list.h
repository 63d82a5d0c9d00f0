#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/motion.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// The loads of a mechanism at a time as one list of numbers, and which of
/// them belong together: per joint its force and its moment as far as they
/// hold the motion, per drive its effort, per element its effort and friction.
/// Forces are in [N], moments in [N m].
class LoadList {
 public:
  /// @param x  any configuration of the system.
  LoadList(const ConstraintSystem& system, const Configuration& x,
           const ForceModel& forces);
  explicit LoadList(const Instant& instant);

  Eigen::Index size() const {
    return static_cast<Eigen::Index>(vector_of_.size());
  }
  /// Number of vectors: forces and moments of joints, efforts of drives and
  /// elements, in this order.
  Eigen::Index vectors() const { return vectors_; }
  Eigen::Index force_of_joint(int j) const { return 2 * j; }
  Eigen::Index moment_of_joint(int j) const { return 2 * j + 1; }
  Eigen::Index drive(int k) const { return 2 * joints_ + k; }
  Eigen::Index element(int k) const { return 2 * joints_ + drives_ + k; }

  /// Allocates nothing. @param multipliers  scaled, of the system's rows.
  /// @param forces  evaluated.
  void get(const ConstraintSystem& system, const Eigen::VectorXd& multipliers,
           const ForceState& acting, Eigen::VectorXd& values) const;
  void get(const Instant& instant, Eigen::VectorXd& values) const;
  /// Squares of the vectors' lengths [N²] or [N² m²].
  void squares(const Eigen::VectorXd& values, Eigen::VectorXd& squares) const;
  /// That of a − b.
  void squares_of_change(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                         Eigen::VectorXd& squares) const;

 private:
  int joints_{}, drives_{};
  Eigen::Index vectors_{};
  std::vector<Eigen::Index> vector_of_;  ///< by number
};

/// Says where the loads of a motion change so much that an instant between
/// two is wanted: by half a percent near a vector's largest length, more
/// where it is smaller, and where it is below half of it never. Loads are those
/// of a LoadList [N], [N m].
class LoadChange {
 public:
  /// @param largest  squares of the vectors' lengths over the motion.
  /// @param coarseness  so many times as much change is let pass.
  LoadChange(const LoadList& list, Eigen::VectorXd largest,
             double coarseness = 1.0);

  bool is_large(const Eigen::VectorXd& a, const Eigen::VectorXd& b);
  /// Squares of the vectors' changes over their largest lengths [1]; 0 where
  /// that is round-off.
  void over_largest(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                    Eigen::VectorXd& squares) const;

 private:
  const LoadList& list_;
  Eigen::VectorXd largest_, at_a_, at_b_, change_;
  double coarseness_;
};

}  // namespace clevis::mechanism
