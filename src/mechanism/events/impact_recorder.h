#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/motion.h"
#include "mechanism/events/contact_inertia.h"
#include "numerics/integrators/ode_system.h"

namespace clevis::mechanism {

/// Records the impacts of an integration: each press of a contact or a stop's
/// end, from then until it lets go. Force and impulse by Lobatto's rule on the
/// dense output of the steps in between. Times are in seconds [s].
class ImpactRecorder {
 public:
  explicit ImpactRecorder(EquationsOfMotion& equations);

  /// Looks at the integrator's last step, up to a time.
  void look(numerics::Integrator& integrator, double until);
  /// Notes what begins to press and what lets go.
  /// @param before  modes of the forces, by event, before time t.
  /// @param y  the state then.
  void pass(double t, const Eigen::VectorXd& y, const std::vector<int>& before);
  /// In the order of their beginning.
  std::vector<Impact> impacts() const { return impacts_; }

 private:
  Impact* open_impact(int event);
  void begin(int event, double t);
  double effort(const Impact& impact, numerics::Integrator& integrator,
                double t);
  void refine(Impact& impact, numerics::Integrator& integrator, double from,
              double to);

  EquationsOfMotion& equations_;
  std::vector<Impact> impacts_;
  std::vector<int> open_;  ///< by event: which impact, or -1
  std::vector<int> last_;  ///< by event: the latest impact, or -1
  Eigen::VectorXd state_;
};

}  // namespace clevis::mechanism
