#pragma once

#include <Eigen/Core>

#include "elasticity/buckling/buckling_on_springs.h"
#include "elasticity/buckling/buckling_problem.h"

namespace clevis::elasticity {

/// The lowest positive λ of K φ = −λ K_G φ over all instants and holds.
struct BucklingMode {
  double factor{};         ///< λ [1]
  bool is_above = false;   ///< there is none below `factor`
  Eigen::Index instant{};  ///< whose loads times λ buckle the part
  std::size_t hold{};
  Eigen::VectorXd shape;  ///< dofs, largest displacement of a node 1
  /// Energy that the stresses of an instant add to a shape over its strain
  /// energy, largest of the shapes that were tried: pulled on, it vibrates at
  /// √(1 + stiffening) of its frequency at most [1].
  double stiffening{};
  /// 1/λ each at the instant with the largest: of the part as its hold has it,
  /// of it as rigid on springs of its mechanism, and of it on these. Sets of
  /// springs that the loads push over by themselves do not count, for the
  /// mechanism moves so; nor do instants at which both are below a tenth, or,
  /// of a part that moves, its own: first order is enough for it.
  struct OnSprings {
    double own{}, springs{};
    /// Times `own` that it has at most where springs alone hold it: clamped at
    /// one end it is as soft as this beside one that is free.
    double softer = 1.0;
    BucklingOnSprings::Together together = {};
    /// Other instants, not solved for, have a larger one of their own.
    bool may_be_larger = false;
    bool counts() const { return springs > 0.0 || together.is_known; }
    /// Its hold makes it softer than its springs and joints do.
    bool rises() const {
      constexpr double kCounts = 0.98;
      return together.is_known && together.yield < kCounts * own;
    }
    /// 1/λ of both together [1]: where it is not known not above the sum
    /// (Southwell).
    double yield() const {
      return together.is_known ? together.yield : softer * own + springs;
    }
  };
  OnSprings on_springs;
  BucklingOnSprings::Position position = {};
  double residual{};  ///< ‖(−K⁻¹ K_G − 1/λ) φ‖_K λ: its square is λ's error
};

/// Linear buckling: K_G from the stresses of each instant; loads keep size and
/// direction while the part moves. One factorisation, of each parity class of
/// the part (EnergyCoordinates). The instant that governs
/// is sought in the space of the shapes that yield most to any stress and of
/// those found so far, then solved for; until no other instant has a lower
/// factor in that space. From a known shape, and others at random should its
/// degree have missed one, nothing else is tried.
///
/// @throws Error F001, F002, F004, L002, M003, M005.
BucklingMode lowest_buckling(const BucklingProblem& problem);

}  // namespace clevis::elasticity
