#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace clevis::mechanism {

/// An interval of time in which the rows of a Jacobian are too nearly dependent
/// for their directions to be clear: where the parts of Gram and Schmidt's
/// vectors along their directions before it change sign, each change a
/// provisional zero. Errors may have a vector cross more than once. Times [s].
class NearSingularInterval {
 public:
  /// @param vectors  number of them.
  explicit NearSingularInterval(Eigen::Index vectors)
      : signs_(Eigen::VectorXd::Ones(vectors)) {}

  bool is_open() const { return is_open_; }
  /// It begins, or goes on.
  void enter();
  /// Directions are clear again.
  void leave();
  /// Last sign of vector i along its direction before: 1 or −1.
  double sign(Eigen::Index i) const { return signs_[i]; }
  /// Vector i has changed its sign at a time.
  void note(Eigen::Index i, double zero);
  /// Provisional zeros so far [s].
  const std::vector<double>& zeros() const { return zeros_; }
  /// The middle one of those of vector i [s]: where an odd number of crossings
  /// by errors about one zero is put.
  std::optional<double> middle_zero(Eigen::Index i) const;

 private:
  bool is_open_ = false;
  Eigen::VectorXd signs_;  ///< by vector
  std::vector<double> zeros_;
  std::vector<Eigen::Index> vectors_;  ///< of zeros_
};

}  // namespace clevis::mechanism
