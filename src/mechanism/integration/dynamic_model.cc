#include "mechanism/integration/dynamic_model.h"

#include <algorithm>

#include "mechanism/mass_matrix/centre_frame.h"

namespace clevis::mechanism {
namespace {

// Local errors add up over a motion; steps are this much stricter, down to
// round-off, and of closed loops to where that governs beside change points.
constexpr double kLocalPart = 0.01;
constexpr double kStrictest = 1e-14, kStrictestOfLoops = 1e-11;

double step_tolerance(const SolvingFrame& frame, double tolerance) {
  return std::max(kLocalPart * tolerance,
                  frame.is_tree ? kStrictest : kStrictestOfLoops);
}

}  // namespace

DynamicModel::DynamicModel(const MechanismDefinition& given,
                           const SimulationSettings& wanted)
    : definition(given),
      settings(wanted),
      frame(frame_at_centres(given)),
      dynamics(given, frame, step_tolerance(frame, wanted.tolerance),
               wanted.duration),
      equations(dynamics.equations()),
      projection(dynamics.projection()),
      equilibrium(given, frame, equations.system()) {}

}  // namespace clevis::mechanism
