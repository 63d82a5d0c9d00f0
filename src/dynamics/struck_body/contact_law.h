#pragma once

#include "loads/history/strike.h"

namespace clevis::dynamics {

/// Force of a contact spring over the approach δ of its two sides [N].
class ContactLaw {
 public:
  explicit ContactLaw(const loads::ContactSpring& spring) : spring_(spring) {}

  double force(double approach) const;
  double potential(double approach) const;  ///< [J]
  double slope(double approach) const;      ///< [N/m]

  /// Mean of the force over the way from a to b: (Φ(b) − Φ(a))/(b − a). A step
  /// under this constant force does exactly the work that the potential gives.
  double mean_force(double a, double b) const;

  /// The mean force of a step that ends at b = b_free − compliance · force.
  /// @param compliance  of both sides over the step, > 0 [m/N].
  double solve_step(double a, double b_free, double compliance) const;

 private:
  loads::ContactSpring spring_;
};

/// Largest approach and force where the striker's energy ½ m v² goes into the
/// spring alone.
struct HeadOn {
  double approach{};   ///< [m]
  double force{};      ///< [N]
  double stiffness{};  ///< force over approach [N/m]
};
/// @param energy  of the striker, ½ m v² [J].
HeadOn head_on(const loads::ContactSpring& spring, double energy);

}  // namespace clevis::dynamics
