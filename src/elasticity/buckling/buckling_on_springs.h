#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/buckling/buckling_problem.h"
#include "elasticity/buckling/stressed_part.h"

namespace clevis::elasticity {

/// Buckling of a part as its mechanism holds it: what joints and drives hold is
/// held, springs yield. 1/λ of S Sᵀ φ + K φ = λ F φ, S the springs and F what
/// the loads bring.
class BucklingOnSprings {
 public:
  /// @param problem, stressed  outlive the object.
  /// @throws Error see seat_means().
  BucklingOnSprings(const BucklingProblem& problem,
                    const StressedPart& stressed);

  /// Instants at which it is asked for, evenly over all; none: nothing springs.
  const std::vector<Eigen::Index>& instants() const { return instants_; }
  /// 1/λ of the part as rigid, over the motions that the mechanism leaves; 0:
  /// its loads do not push it over [1].
  /// @param form  F of the rigid motions at the instant. @throws Error F003.
  double of_rigid(Eigen::Index instant, const Eigen::MatrixXd& form) const;

  bool is_sprung(Eigen::Index instant) const;
  /// Whether no joint holds the part.
  bool hold_alone() const { return hold_alone_; }
  /// Whether the part keeps its place while its motion lasts: bodies that
  /// springs swing are at rest between these.
  bool stands() const { return stands_; }
  /// How its loads leave a part that stands while its motion lasts.
  struct Position {
    /// Factor of the loads at the motion's end under which these push it out of
    /// its position, below 1, or any with what yields slowly; 0 where
    /// nothing but inertia holds it; absent: they do not, or it moves [1].
    std::optional<double> topples = std::nullopt;
    /// They do but for force elements that do not count here.
    bool is_open = false;
    bool stands = false;         ///< of a part that moves nothing is said
    bool yields_slowly = false;  ///< friction or gas, see hold_at_rest
  };
  /// @param form  as of of_rigid(), at the last instant. @throws Error F003.
  Position position(const Eigen::MatrixXd& form) const;

  struct Together {
    double yield{};  ///< 1/λ of the part on its springs [1]
    /// Joints and drives hold it no more often than balance needs, they and
    /// the springs leave nothing free, and the iteration has settled.
    bool is_known = false;
  };
  /// Inverse iteration in a Ritz space that grows: with rigid motions and what
  /// unit reactions bend, it holds what each step finds.
  /// @param start  unknowns of shapes to begin with, equations × columns [√J].
  Together together(Eigen::Index instant, const Eigen::MatrixXd& start) const;

 private:
  class Space;
  double rigid_yield(const loads::SeatHold& hold,
                     const Eigen::MatrixXd& form) const;
  /// Factor of the loads that pushes rigid motions over; absent: none does.
  std::optional<double> factor_of_position(const loads::SeatHold& hold,
                                           const Eigen::MatrixXd& form) const;
  loads::SeatHold hold_at(Eigen::Index instant) const;
  /// seat_means() of what slides touch then.
  Eigen::MatrixXd means_at(Eigen::Index instant) const;

  const BucklingProblem& problem_;
  const loads::LoadHistory& history_;
  const StressedPart& stressed_;
  std::string name_;
  std::vector<Eigen::Index> instants_;
  bool stands_ = false, hold_alone_ = false;
  Eigen::MatrixXd rigid_;  ///< motions of the part, dofs × motions
  /// Of the seats by these, six each × motions: wherever slides touch.
  Eigen::MatrixXd motions_;
};

}  // namespace clevis::elasticity
