#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "loads/history/load_history.h"
#include "part/material.h"
#include "part/part_definition.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// A shape that buckles the part, by another degree on the same cells.
struct KnownShape {
  Discretization<3> discretization;
  Eigen::VectorXd shape;  ///< its dofs
};

/// A part and the loads that may buckle it.
struct BucklingProblem {
  Discretization<3> discretization;
  const part::Material& material;
  const loads::LoadHistory& history;
  /// Components held at zero; empty: a free part in balance.
  part::Supports fixed;
  /// Of a free part: pairs of groups whose pins hold it as a whole (PinHold);
  /// each is taken by itself, the lowest factor counts. Not empty.
  std::vector<std::vector<std::string>> holds;
  std::string name;               ///< of the part, for messages
  part::Foundations foundations;  ///< elastic beds under faces
  /// Of a plate: what the discretisation is a layer over, of degree 3 through
  /// the thickness. Null: a solid.
  const Discretization<2>* plane = nullptr;
  /// Of one instant with one hold: near to what is sought. Null: none is known.
  const KnownShape* known = nullptr;
  double highest = 100.0;  ///< factors beyond are not looked for [1]
};

/// The lowest positive λ of K φ = −λ K_G φ over all instants and holds.
struct BucklingMode {
  double factor{};         ///< λ [1]
  bool is_above = false;   ///< there is none below `factor`
  Eigen::Index instant{};  ///< whose loads times λ buckle the part
  std::size_t hold{};
  Eigen::VectorXd shape;  ///< dofs, largest displacement of a node 1
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
