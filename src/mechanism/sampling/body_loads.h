#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// The loads of a mechanism as its bodies feel them, as one list of numbers:
/// forces and moments of joints, drives, couplings and elements and what
/// inertia needs, in the frame of each body that they act on. A body that
/// spins along with its loads feels none of them change. Forces are in [N],
/// moments in [N m], angular accelerations and squares of angular velocities
/// times √(tr I · m) in [N].
class BodyLoads {
 public:
  /// Numbers that belong together.
  struct Vector {
    Eigen::Index begin{};
    int count{};
    bool is_moment = false;
    bool is_peak = false;     ///< its largest length is a result
    std::vector<int> bodies;  ///< that feel it; ground is none
  };

  /// @param length  of the links' order [m].
  BodyLoads(const MechanismDefinition& definition, double length);

  Eigen::Index size() const { return size_; }
  std::size_t bodies() const { return definition_.bodies.size(); }
  const std::vector<Vector>& vectors() const { return vectors_; }
  Eigen::VectorXd of(const Instant& instant) const;
  /// Lengths of the vectors.
  Eigen::VectorXd lengths(const Eigen::VectorXd& values) const;
  /// Scale of a change of each vector: its largest length, but at least 1e-4 of
  /// the largest load on its bodies.
  /// @param largest  lengths over the motion.
  Eigen::VectorXd scales(const Eigen::VectorXd& largest) const;

 private:
  void add(int count, std::vector<int> bodies, bool is_moment, bool is_peak);
  void put_joints(const Instant& instant, Eigen::VectorXd& values,
                  Eigen::Index& at) const;
  void put_inertia(const Instant& instant, Eigen::VectorXd& values,
                   Eigen::Index& at) const;

  const MechanismDefinition& definition_;
  double length_;
  Eigen::Index size_ = 0;
  std::vector<Vector> vectors_;
};

}  // namespace clevis::mechanism
