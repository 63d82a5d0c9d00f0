#include "report/summary/mechanism_quantities.h"

namespace clevis::report {
namespace {

constexpr Rule kCountRule = exact("a count");
constexpr Rule kInstantsRule = {
    compare_within(0.05, 0.0),
    "another sampling is another run, but of the instants that clevis adds at "
    "peaks round-off may choose one or another"};
constexpr Rule kForceRule = {
    compare_within(1e-6, 1e-6),
    "reactions solve small dense systems: only round-off (1e-12) may move "
    "them"};

/// A part of a peak of a joint.
auto of_peak(Peak JointPeaks::*peak, double Peak::*member) {
  return [=](const JointPeaks& joint) {
    return joint.*peak.*member;
  };
}

auto effort_of(EffortKind kind) {
  return [kind](const DrivePeak& drive) {
    return drive.kind == kind ? std::optional(drive.effort.value)
                              : std::nullopt;
  };
}

}  // namespace

const Quantities<MechanismSummary>& mechanism_quantities() {
  using S = MechanismSummary;
  static const Quantities<S> rows{
      quantity<S>({"mobility", "/mobility", "", "", kCountRule}, &S::mobility),
      quantity<S>({"redundant_constraints", "/redundant_constraints", "", "",
                   kCountRule},
                  &S::redundant_constraints),
      quantity<S>({"instants", "/instants", "", "", kInstantsRule},
                  &S::instants),
      quantity<S>({"instants_left_out", "/instants_left_out"},
                  &S::instants_left_out),
      quantity<S>({"max_closure_error", "/max_closure_error_mm", "mm"},
                  &S::max_closure_error),
      quantity<S>({"max_power_balance_error", "/max_power_balance_error", "1"},
                  &S::max_power_balance_error),
  };
  return rows;
}

const Quantities<JointPeaks>& joint_quantities() {
  using S = JointPeaks;
  static const Quantities<S> rows{
      quantity<S>({"name", "/name"}, &S::name),
      quantity<S>({"peak_force", "/peak_force_N", "N", "", kForceRule},
                  of_peak(&S::force, &Peak::value)),
      quantity<S>({"peak_instant", "/at_s", "s", "", kInstantRule},
                  of_peak(&S::force, &Peak::at)),
      quantity<S>(
          {"peak_moment", "/peak_moment_Nm", "Nm", "", like_reactions(1e-6)},
          of_peak(&S::moment, &Peak::value)),
      quantity<S>({"moment_instant", "/moment_at_s", "s"},
                  of_peak(&S::moment, &Peak::at)),
  };
  return rows;
}

const Quantities<DrivePeak>& drive_quantities() {
  using S = DrivePeak;
  static const Quantities<S> rows{
      quantity<S>({"name", "/name"}, &S::name),
      quantity<S>(
          {"peak_effort", "/peak_effort_N", "N", "", like_reactions(1e-6)},
          effort_of(EffortKind::kForce)),
      quantity<S>(
          {"peak_torque", "/peak_effort_Nm", "Nm", "", like_reactions(1e-6)},
          effort_of(EffortKind::kTorque)),
      quantity<S>({"peak_instant", "/at_s", "s", "", kInstantRule},
                  [](const S& drive) {
                    return drive.effort.at;
                  }),
  };
  return rows;
}

}  // namespace clevis::report
