#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/vibration/vibrating_part.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// What pins do to a part that vibrates beyond its mean motions. A mechanism
/// that holds seats in the mean (neighbour_hold.h) reacts on them by linear
/// tractions. Pins press as under the loads at rest: where a wrench adds to the
/// largest that the seat bears, by that pressure's derivative. Both have the
/// same resultant, so their difference bends the part beside the seat alone. Of
/// a bore's moments; in a plane there are none.
template <int dim>
class PinReactions {
 public:
  /// @param part     as supported_part(). @param history  that holds it.
  /// @param instants  of it, among which the largest wrench is sought.
  /// @throws Error see surface_loads.
  PinReactions(const VibratingPart<dim>& part,
               const loads::LoadHistory& history,
               const std::vector<Eigen::Index>& instants,
               const std::string& part_name);

  /// Answers of the part to unit moments [1/N]: pressed less linear tractions,
  /// equations × moments, without rigid motion.
  const Eigen::MatrixXd& differences() const { return differences_; }
  /// Those moments in vibrations, moments × shapes: what moving a seat alone
  /// takes, which asks nothing of shapes but to be near to vibrations.
  /// @param shapes   equations × shapes [1/√kg]. @param squares  ω² [1/s²].
  Eigen::MatrixXd reactions(const Eigen::MatrixXd& shapes,
                            const Eigen::VectorXd& squares) const;

  /// Answers at rest as if pins had pressed by linear tractions: what they
  /// press beside these follows at once and swings nothing.
  /// @param answers  equations × columns. @param coefficients  of them at all
  ///   instants of the history, columns × instants.
  Eigen::MatrixXd spread_evenly(const Eigen::MatrixXd& answers,
                                const Eigen::MatrixXd& coefficients) const;

 private:
  Eigen::MatrixXd differences_;
  Eigen::MatrixXd moments_;  ///< of the loads at rest, × instants
  /// K ψ, M ψ: motions ψ that move a seat by one along a wrench, and no other.
  Eigen::MatrixXd stiffness_, mass_;
};

}  // namespace clevis::elasticity
