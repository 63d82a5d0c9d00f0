#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "dynamics/strike/strike_run.h"
#include "dynamics/struck_body/excited_shapes.h"
#include "dynamics/systems/linear_system.h"
#include "loads/history/strike.h"

namespace clevis::dynamics {

/// Method by which the struck body is integrated in time.
enum class Route {
  kAuto,    ///< modal, damped where the shapes do not suffice
  kDirect,  ///< all equations by the midpoint rule, or the damping scheme
  kModal,   ///< shapes of a space that the contact excites, each exactly
};

/// Whether the integration in time takes out waves that are too short for
/// shapes or mesh: behind a front they ring, and a scheme that keeps the energy
/// keeps them for ever.
enum class Damping {
  kAuto,    ///< for ideal steps, and where undamped shapes do not settle
  kNone,    ///< the energy is kept
  kFronts,  ///< always
};

struct StrikeOptions {
  Route route = Route::kAuto;
  Damping damping = Damping::kAuto;
  double tolerance = 1e-3;  ///< of the contact's displacement and impulse [1]
  int samples = 400;        ///< instants after t = 0
  int fewest_modes = 24, most_modes = 480;
  int front_modes = 271;  ///< where fronts are damped, at the least
  /// Of the fronts that the modal route keeps: the shapes must then settle
  /// under that damping; 0: as short as front_modes shapes allow [s].
  double wave_front_time = 0.0;
  int most_direct_steps = 50000;
  int most_modal_steps = 400000;
  /// Of each mode, over the critical; the direct route has none [1].
  double modal_damping = 0.0;
};

/// Answer of a body to a strike: u(t_i) = columns · coefficients of the i-th
/// sample of the run.
struct StrikeSolution {
  StrikeRun run;
  Eigen::MatrixXd columns;  ///< shapes; empty: run.states are all equations
  bool is_modal = false;
  int modes{};               ///< of the modal route
  int steps{};               ///< of the last run
  int solves{};              ///< with a factor, of all runs or for the shapes
  double time_error{};       ///< estimated, of what `difference` compares [1]
  double mode_error{};       ///< likewise
  double shape_frequency{};  ///< highest of the shapes [Hz]
  /// Step of the damping scheme, 0: the energy was kept. Stresses are those of
  /// a front that takes about so long [s].
  double damping_time{};
  double rise_time{};           ///< of the contact force, modal route [s]
  double contact_compliance{};  ///< static, of the body alone [m/N]
  std::string reason;           ///< why this route
  double contact_stiffness{};   ///< of the spring computed [N/m^exponent]
  /// The contact was infinitely stiff: a spring of 1000 times the body's own
  /// stiffness was put in its place.
  bool is_ideal = false;
  bool within_tolerance = false;

  /// Sum of both errors [1].
  double error() const { return time_error + mode_error; }
};

/// @param contact  c [1]: cᵀu is the displacement of the contact [m].
/// @param place    entity for messages ("part DCE").
/// @throws Error F002; F005 for a strike without mass, spring or way.
StrikeSolution solve_strike(const LinearSystem& system,
                            const Eigen::VectorXd& contact,
                            const loads::Strike& strike,
                            const StrikeOptions& options,
                            const std::string& place);

/// The same on shapes that are there, of `system` and `contact` [1]: those of
/// strikes before are not made again.
StrikeSolution solve_strike(const LinearSystem& system,
                            const Eigen::VectorXd& contact,
                            ExcitedShapes& shapes, const loads::Strike& strike,
                            const StrikeOptions& options,
                            const std::string& place);

/// Whether values of ever finer models (degrees or meshes doubled) do not
/// settle: the last change is above 1 % and not clearly below the one before,
/// as of the root stress under an ideal velocity step. Only relative changes
/// count.
bool grows_with_refinement(const std::vector<double>& values);

}  // namespace clevis::dynamics
