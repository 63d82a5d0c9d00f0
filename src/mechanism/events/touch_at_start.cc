#include "mechanism/events/touch_at_start.h"

#include <cmath>
#include <limits>

#include "base/values/index.h"
#include "mechanism/events/contact_inertia.h"

namespace clevis::mechanism {
namespace {

constexpr double kRoundOff = 1e-12;  // of a length

bool starts_to_press(EquationsOfMotion& equations, std::size_t element,
                     int end) {
  const ElementResponse& now = equations.state().loads.forces.elements[element];
  const double resting = equations.forces().element(element).velocity_tolerance;
  return std::abs(now.depth_rate[index(end)]) <= resting &&
         opening_acceleration(equations, element, end) < 0.0;
}

}  // namespace

bool choose_modes_of_touching(EquationsOfMotion& equations, double t,
                              const Eigen::VectorXd& y) {
  ForceModel& forces = equations.forces();
  const double round_off = kRoundOff * equations.layout().length();
  equations.solve(t, y);
  std::vector<ElementResponse> sides = equations.state().loads.forces.elements;
  bool found = false;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    for (const int end : {0, 1}) {
      double& depth = sides[k].depth[index(end)];
      if (!forces.element(k).presses(end) || std::abs(depth) > round_off) {
        continue;
      }
      const bool presses = starts_to_press(equations, k, end);
      depth = presses ? std::numeric_limits<double>::min() : 0.0;
      sides[k].unbounded[index(end)] = 0.0;
      found = true;
    }
  }
  if (!found) return false;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).presses(0) || forces.element(k).presses(1)) {
      forces.element(k).choose_modes(sides[k]);
    }
  }
  return true;
}

}  // namespace clevis::mechanism
