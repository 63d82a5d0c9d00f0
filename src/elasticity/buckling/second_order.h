#pragma once

#include <Eigen/Core>

#include "elasticity/buckling/buckling_problem.h"
#include "elasticity/buckling/stressed_part.h"

namespace clevis::elasticity {

/// A part whose stresses and whose spin act on what its loads displace:
/// (K + K_G − G − Ω² M) u = f, beside K u = f. K_G is of the stresses of linear
/// theory; loads keep size and direction in the part's frame, but for what G
/// says that they gain (SeatPushes).
class SecondOrderPart {
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

  /// @param problem, part  outlive the object.
  /// @throws Error as of lowest_buckling().
  SecondOrderPart(const BucklingProblem& problem, const HeldPart& part)
      : part_(part), stressed_(problem, part) {}

  bool is_stressed() const { return stressed_.coefficients().rows() > 0; }
  /// Amounts of the load columns, columns × instants.
  const Eigen::MatrixXd& coefficients() const {
    return stressed_.coefficients();
  }
  /// Displacements of the load columns by linear theory, dofs × columns [m].
  Eigen::MatrixXd columns(std::size_t hold) const {
    return part_.held(stressed_.displaced(), hold);
  }
  /// Displacements under amounts of them [m].
  Eigen::VectorXd linear(const Eigen::VectorXd& amounts,
                         std::size_t hold) const {
    return part_.held(stressed_.displaced() * amounts, hold);
  }
  /// Of an instant.
  Eigen::MatrixXd gain(Eigen::Index instant) const {
    return stressed_.pushes().gain(instant);
  }
  Answer answer(const Loads& loads, std::size_t hold) const;

 private:
  const HeldPart& part_;
  StressedPart stressed_;
};

}  // namespace clevis::elasticity
