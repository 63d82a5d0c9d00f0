#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "dynamics/systems/block_krylov.h"
#include "elasticity/assembly/initial_stress.h"
#include "elasticity/assembly/node_pairs.h"
#include "elasticity/buckling/buckling_problem.h"
#include "elasticity/buckling/energy_coordinates.h"
#include "elasticity/buckling/seat_pushes.h"
#include "elasticity/holds/pin_hold.h"

namespace clevis::elasticity {

/// A part whose stiffness is factored, as its holds have it. Unknowns are
/// energy coordinates.
class HeldPart {
 public:
  /// @param problem  outlives the object.
  /// @throws Error as of lowest_buckling().
  explicit HeldPart(const BucklingProblem& problem);

  Eigen::Index equations() const { return coordinates_->size(); }
  /// Nothing but its inertia holds it.
  bool is_free() const { return is_free_; }
  std::size_t holds() const { return std::max<std::size_t>(1, holds_.size()); }
  /// Whether a hold is one of an instant's.
  bool is_held(std::size_t hold, Eigen::Index instant) const {
    return holds_.empty() || problem_.holds[hold].is_at(instant);
  }
  const NodePairs& pairs() const { return pairs_; }
  const EnergyCoordinates& coordinates() const { return *coordinates_; }

  /// Displacements as the hold has them, whatever it holds beyond six
  /// conditions [m].
  Eigen::MatrixXd displacements(const Eigen::MatrixXd& unknowns,
                                std::size_t hold) const;
  /// Those of the unknowns that it leaves free [m].
  Eigen::MatrixXd shapes(const Eigen::MatrixXd& unknowns,
                         std::size_t hold) const;
  /// Unknowns less what strains a part that is held by more than six
  /// conditions [√J].
  Eigen::MatrixXd freed(const Eigen::MatrixXd& unknowns,
                        std::size_t hold) const;
  /// What a hold beyond six conditions takes out of unknowns: orthonormal,
  /// equations × columns.
  const Eigen::MatrixXd& beyond(std::size_t hold) const {
    return beyond_[hold];
  }
  /// Displacements [m] less the rigid motion that the hold does not let them.
  Eigen::MatrixXd held(const Eigen::MatrixXd& u, std::size_t hold) const;
  /// Motions of a free part as a whole, dofs × 6, pure numbers; of a held one
  /// none.
  Eigen::MatrixXd rigid() const;
  /// Of rigid(), 6 × columns: what of displacements [m] the hold takes out.
  Eigen::MatrixXd broken(const Eigen::MatrixXd& u, std::size_t hold) const;
  /// Y of a displacement, whatever rigid motion is in it: Fᵀ φ = F⁻¹ K φ.
  Eigen::MatrixXd unknowns(const Eigen::MatrixXd& u) const;
  /// F⁻¹ of nodal forces [N], balanced by the hold's reactions [√J].
  Eigen::MatrixXd answer_in_balance(const Eigen::MatrixXd& forces,
                                    std::size_t hold) const;
  /// Likewise, freed() [√J].
  Eigen::MatrixXd answer(const Eigen::MatrixXd& forces, std::size_t hold) const;
  /// F⁻¹ S F⁻ᵀ: K⁻¹ S as it acts on Y, without a product with K.
  /// @param forces  S u [N] on displacements [m], dofs × columns.
  dynamics::SelfAdjoint answer_to(
      std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)> forces,
      std::size_t hold) const;
  MassMatrix mass() const;
  /// Of its vibrations at rest [rad/s].
  double lowest_frequency(std::size_t hold) const;

 private:
  const BucklingProblem& problem_;
  const Discretization<3>& part_;
  bool is_free_;
  std::shared_ptr<const EnergyCoordinates> coordinates_;
  NodePairs pairs_;
  std::unique_ptr<MeanMotions<3>> motions_;  ///< of a free part
  std::vector<PinHold<3>> holds_;
  std::vector<Eigen::MatrixXd> beyond_;  ///< by hold; one at least
};

/// The part's energy coordinates, for problems that differ in their loads only.
std::shared_ptr<const EnergyCoordinates> energy_coordinates(
    const BucklingProblem& problem);

/// With the displacements of its loads, and their stresses.
class StressedPart {
 public:
  /// @param problem, part  outlive the object.
  /// @throws Error as of lowest_buckling().
  StressedPart(const BucklingProblem& problem, const HeldPart& part);

  const HeldPart& part() const { return part_; }
  Eigen::Index instants() const { return coefficients_.cols(); }
  bool is_stressed() const { return coefficients_.rows() > 0; }
  /// Factor up to which it is looked for [1].
  double highest() const { return highest_; }
  /// Amounts of the load columns, columns × instants [1].
  const Eigen::MatrixXd& coefficients() const { return coefficients_; }
  const InitialStress& stress() const { return *stress_; }
  const SeatPushes& pushes() const { return pushes_; }
  /// What the loads of an instant bring: forces [N] on displacements u [m],
  /// dofs × columns. The object outlives it.
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)> pushing(
      Eigen::Index instant) const;
  /// Unknowns of linear theory under the load columns [√J].
  const Eigen::MatrixXd& loaded() const { return loaded_; }
  /// Their displacements, of a free part up to a rigid motion, dofs × columns
  /// [m].
  const Eigen::MatrixXd& displaced() const { return displaced_; }
  /// The same as a hold has them [m].
  Eigen::MatrixXd displaced(std::size_t hold) const {
    return part_.held(displaced_, hold);
  }
  /// Under amounts of the load columns [m].
  Eigen::VectorXd displaced(const Eigen::VectorXd& amounts,
                            std::size_t hold) const {
    return part_.held(displaced_ * amounts, hold);
  }

 private:
  StressedPart(const BucklingProblem& problem, const HeldPart& part,
               const std::vector<SurfaceLoads>& surfaces);

  const HeldPart& part_;
  double highest_;
  Eigen::MatrixXd coefficients_;
  Eigen::MatrixXd loaded_, displaced_;  ///< by the load columns
  std::unique_ptr<InitialStress> stress_;
  SeatPushes pushes_;
};

}  // namespace clevis::elasticity
