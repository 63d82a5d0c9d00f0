#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/mass_matrix.h"
#include "elasticity/buckling/reduced_basis.h"
#include "elasticity/buckling/stressed_part.h"

namespace clevis::elasticity {

/// A part with one of its holds whose stresses and whose spin act on what its
/// loads displace: (K + K_G − G − Ω² M) u = f, beside K u = f. K_G is of the
/// stresses of linear theory; loads keep size and direction in the part's
/// frame, but for what G says that they gain (SeatPushes).
///
/// A load is solved in a basis of those before it. Where its residual is not
/// small there, conjugate gradients go on, and what they find enters the basis.
/// A basis that shows a shape without stiffness proves that the part has one.
class SecondOrderSolver {
 public:
  /// Loads in amounts of load columns.
  struct Loads {
    Eigen::VectorXd stressing;  ///< whose stresses K_G has
    Eigen::MatrixXd gain;       ///< of SeatPushes, with those
    Eigen::VectorXd spun;       ///< that move on with what they displace
    /// That turn in the part's frame as it spins, for they stand still in
    /// space: (K + K_G) u = f.
    Eigen::VectorXd still;
    Eigen::Vector3d omega;  ///< in L [rad/s]
  };
  enum class State {
    kStable,
    kUnstable,  ///< it buckles, or whirls, under less
    kOpen       ///< the solution did not settle
  };
  struct Answer {
    Eigen::VectorXd displacement;  ///< dofs [m]
    State state{};
  };

  /// @param part  outlives the object.
  SecondOrderSolver(const StressedPart& part, std::size_t hold);

  Answer answer(const Loads& loads);

 private:
  /// A matrix of the nodes that acts on displacements.
  struct Term {
    bool is_spin = false;
    /// Amounts of load columns, or Ω² I − Ω Ωᵀ as six components; orthonormal
    /// to those of the other terms of its kind.
    Eigen::VectorXd direction;
    std::shared_ptr<const MassMatrix> matrix;
    Eigen::Matrix3d turns;  ///< a node's forces over displacements
  };
  /// What acts on displacements under some loads.
  struct Action {
    Eigen::VectorXd terms;  ///< amounts
    Eigen::MatrixXd gain;
  };

  /// Whether `what` is a sum of the terms of a kind; if not, the direction that
  /// lacks.
  std::optional<Eigen::VectorXd> lacking(bool is_spin,
                                         const Eigen::VectorXd& what) const;
  void add_amounts(bool is_spin, const Eigen::VectorXd& what,
                   Eigen::VectorXd& amounts) const;
  void append(Term term);
  Action action(const Loads& loads);
  Action without_spin(Action action) const;

  /// @param u  dofs × columns [m].
  Eigen::MatrixXd image(const Term& term, const Eigen::MatrixXd& u) const;
  /// What is not in the basis yet, where there is room.
  void append(const Eigen::MatrixXd& unknowns);

  /// F⁻¹ of the forces on what unknowns displace.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> answer_to(
      const Action& action) const;
  /// Adds the displacement under a load, by linear theory of unknowns `load`.
  State add(const Action& action, const Eigen::VectorXd& load,
            Eigen::VectorXd& displacement);

  const StressedPart& part_;
  std::size_t hold_;
  std::vector<Term> terms_;
  ReducedBasis basis_;
  Eigen::MatrixXd displaced_;  ///< by the basis [m]
  Eigen::MatrixXd motions_;    ///< of the seats, by the basis
};

}  // namespace clevis::elasticity
