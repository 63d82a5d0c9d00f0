#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/models/level.h"
#include "elasticity/problem/nodal_field.h"

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
template <int dim>
class DeflectionWatch {
 public:
  /// One more degree.
  /// @param sets  that it was solved for: the job's, or of each some instants.
  void take(const std::vector<LoadSet>& sets, const Level<dim>& level);
  /// The last degree was for nothing.
  void drop() { degrees_.pop_back(); }

  /// Of the instant that deflects the part most of those that all degrees
  /// have; if the last has another that does more, twice that. Not less than
  /// what places that change still may reach: the largest may stand where the
  /// cells cannot show it yet.
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
  /// The displacement of the instant that deflects the part most.
  struct Farthest {
    Instant instant;
    elasticity::NodalField<dim> field;
  };
  struct Degree {
    int degree{}, dofs{};
    std::map<Instant, Value> values;
    std::optional<Farthest> farthest;
    /// What the largest displacement may grow by, if each place goes on as it
    /// did since the degree before, over it [1].
    double may_grow{};
    double time_error{};  // [m]
    double largest{};     // [m]
  };

  bool all_have(const Instant& instant) const;
  /// Of the farthest instant of the degree before, here `may_grow`.
  static double growth_after(const Degree& before,
                             const std::vector<LoadSet>& sets,
                             const Level<dim>& level);

  std::vector<Degree> degrees_;
};

}  // namespace clevis::assessment
