#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "assessment/second_order/held_points.h"
#include "assessment/second_order/second_order_loads.h"
#include "elasticity/buckling/second_order_solver.h"

namespace clevis::assessment {

/// Points of a load set with one hold of the part, solved in second order.
class SolvedPoints {
 public:
  /// @param bent    bent_by_pins() with the hold.
  /// @param softer  of K_G's stresses than of linear theory's [1].
  /// @param found   takes in what is solved: the largest, or that nothing
  /// holds.
  ///   All outlive the object.
  SolvedPoints(const LinearSet& linear, const elasticity::StressedPart& part,
               const HeldPoints& points, std::vector<bool> bent, double softer,
               const PartResult& result, SecondOrderResult& found);

  struct Reached {
    double peak{}, deflection{};  ///< [Pa], [m]
  };
  Reached take(std::size_t i);
  /// A share of the way from a point to the next.
  Reached take_between(std::size_t from, double share);

  /// Loads that grow spin the part as well: of those whose spin counts, whether
  /// it bears so many times as much.
  void look_at_growth(double wanted);

 private:
  using Solver = elasticity::SecondOrderSolver;
  /// Over linear theory's [1].
  struct Rise {
    double stress = 1.0, deflection = 1.0;
  };

  /// @param more  of K_G's stresses than of linear theory's [1].
  Solver::Answer answer(const LoadPoint& point, double more,
                        const Eigen::Vector3d& omega);
  /// Takes the part's state in where there is none.
  std::optional<Rise> rise_of(const LoadPoint& point, const LinearPoint& linear,
                              double more, const Eigen::Vector3d& omega);
  /// @param i  of the points: where it is, or the one before it.
  Reached take(std::size_t i, const LoadPoint& point, const LinearPoint& linear,
               double yield);
  /// What the least of the buckling factors leaves of a rise that its most has.
  double certain(double rise) const;

  const LinearSet& linear_;
  const HeldPoints& points_;
  std::vector<bool> bent_;  ///< by instant
  double softer_;
  const PartResult& result_;
  SecondOrderResult& found_;
  const elasticity::StressedPart& part_;
  std::optional<Solver> solver_;  ///< where one is asked for
};

}  // namespace clevis::assessment
