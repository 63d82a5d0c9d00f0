#pragma once

#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// What acts on a part at the instants of a load set: forces, and moments over
/// the part's size, on its surface and, of a mass in its far corner, by
/// inertia. They are vectors that turn with the part's frame.
class ActingForces {
 public:
  ActingForces(const PartJob& job, const LoadSet& set);

  /// Components by instant, one vector below the other [N].
  const Eigen::MatrixXd& values() const { return values_; }

  /// Components of each vector along axes of its own, of those that reach
  /// `least`: the first axis is along the vector where it is largest, the next
  /// along what is largest of the rest. Of like ones the earliest counts, so
  /// that the frame's round-off does not.
  /// @param values  like values() [N]. @param least  > 0 [N].
  Eigen::MatrixXd along_own_axes(Eigen::MatrixXd values, double least) const;

 private:
  Eigen::MatrixXd values_;
  std::vector<Eigen::Index> begins_;  ///< rows of the vectors, and the end
};

}  // namespace clevis::assessment
