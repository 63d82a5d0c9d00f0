#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/models/level.h"

namespace clevis::assessment {

/// How far the largest deflection of the last degree may be off [1].
struct DeflectionError {
  double mesh{};  ///< to either side
  /// Between the instants, and by what was admitted of their loads; upwards
  /// only.
  double time{};
};

/// What the largest deflection is at least and at most [m].
struct DeflectionBand {
  double low{}, high{};
};

/// Follows the largest deflection of each instant through the degrees.
class DeflectionWatch {
 public:
  /// One more degree.
  /// @param sets  that it was solved for: the job's, or of each some instants.
  template <int dim>
  void take(const std::vector<LoadSet>& sets, const Level<dim>& level);
  /// The last degree was for nothing.
  void drop() { degrees_.pop_back(); }

  /// Of the instant that deflects the part most of those that all degrees
  /// have; if the last has another that does more, twice that.
  DeflectionError error() const;
  /// Of the last degree's largest deflection [m].
  DeflectionBand band() const;

  /// Error of a displacement at a point over it [1].
  /// @param label  of the case's instant.
  /// @param values  of all degrees [m].
  double probe_error(const std::string& label,
                     const std::vector<double>& values) const;

 private:
  struct Value {
    double deflection{}, energy{};
  };
  using Instant = std::pair<std::string, double>;  // label, time
  struct Degree {
    int degree{}, dofs{};
    std::map<Instant, Value> values;
    double time_error{};  // [m]
    double largest{};     // [m]
  };

  bool all_have(const Instant& instant) const;

  std::vector<Degree> degrees_;
};

}  // namespace clevis::assessment
