#pragma once

#include <Eigen/Core>

#include "dynamics/struck_body/struck_body.h"
#include "loads/history/strike.h"

namespace clevis::dynamics {

/// Motion of a body and its striker with one step size, at even samples; both
/// touch at rest of the body, without force, at t = 0.
struct StrikeRun {
  double step{};                  ///< [s]
  Eigen::VectorXd time;           ///< of the samples [s]
  Eigen::VectorXd force;          ///< of the contact [N]
  Eigen::VectorXd impulse;        ///< ∫ force dt up to then [N s]
  Eigen::VectorXd contact;        ///< mean displacement of the face y [m]
  Eigen::VectorXd position;       ///< of the striker [m]
  Eigen::VectorXd speed;          ///< of the striker [m/s]
  Eigen::VectorXd strain_energy;  ///< [J]
  Eigen::MatrixXd states;         ///< StruckBody::state() a column
  // Over all steps:
  double peak_force{}, peak_force_time{};      ///< [N], [s]
  double peak_contact{}, peak_contact_time{};  ///< [m], [s]
  double release_time{};  ///< the force is zero for good; < 0: in touch at the
                          ///< end [s]
  int touches{};          ///< times that the force rises from zero
  /// |E(t) − E(0) − F x| over ½ m v² + |F| x: largest over the samples [1].
  double energy_error{};
};

/// Steps whose contact force is constant and equal to the mean of the contact
/// spring over the step's own way: the sum of all energies is kept to
/// round-off, whatever the step.
/// Source: [Gonzalez1996], for contact [LaursenChawla1997].
/// @param samples  after t = 0.
/// @param stride   steps from one sample to the next.
StrikeRun run_strike(StruckBody& body, const loads::Strike& strike,
                     double duration, int samples, int stride);

/// Difference of two runs with the same samples [1]: largest of contact
/// displacement, impulse and strain energy over their largest, and of the peak
/// force.
double difference(const StrikeRun& a, const StrikeRun& b);

}  // namespace clevis::dynamics
