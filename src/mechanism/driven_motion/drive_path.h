#pragma once

#include <vector>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Cuts time where drives turn round and so short that none moves far, so
/// that a motion is followed whatever its instants. Times are in seconds [s].
class DrivePath {
 public:
  /// @param counts_turns  so that no turn is missed, without loops too.
  DrivePath(const MechanismDefinition& definition, const SolvingFrame& frame,
            bool counts_turns);

  /// @throws Error K008 if a motion would take hours to follow.
  void require_few_steps(double duration, int instants) const;

  /// Times after `from`, the last one is `to`.
  std::vector<double> steps(double from, double to) const;

 private:
  std::vector<double> turns(double from, double to) const;
  double travel(double from, double to) const;
  void cut(double from, double to, std::vector<double>& times) const;
  [[noreturn]] void refuse(double duration) const;

  const MechanismDefinition& definition_;
  double length_;
  bool is_followed_;
};

}  // namespace clevis::mechanism
