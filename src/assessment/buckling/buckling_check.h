#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/buckling/buckling_model.h"
#include "assessment/buckling/held_by_springs.h"
#include "assessment/job/part_job.h"
#include "elasticity/buckling/buckling.h"

namespace clevis::assessment {

/// Linear buckling of the part, and its shape.
struct BucklingCheck {
  BucklingResult result;
  std::optional<BucklingShape> shape;
  /// By load set, of its motion alone: by how much its stresses raise the
  /// square of a first frequency at most [1].
  std::vector<double> stiffening;
  /// By the model's lowest_degree(); 0: not known.
  double of_lowest_degree{};
  /// By the lowest degree, of the load set with the largest yield.
  elasticity::BucklingMode::OnSprings on_springs;
  Standing standing;
  double seconds{};
};

/// Linear buckling of a part under all its load sets, with rising degrees: all
/// instants with the first, the one that governs with the others, until the
/// limit lies outside the band. Plates by terms through their thickness, else
/// the mesh as it is. What cannot be computed (memory) is left out, and the
/// remark says why.
/// @param swings  by load set, or none; factors are looked for as far as these
///   make loads larger.
/// @throws Error of elasticity::lowest_buckling but F001, F002, F004, F007,
/// M005.
BucklingCheck check_buckling(const PartJob& job,
                             const std::vector<Swing>& swings,
                             BucklingModel& model);

/// Of a part that joints hold more often than balance needs: its band goes on
/// to the factor that it has if all hold.
/// @return whether the band has grown.
bool widen_by_all_holds(const PartJob& job, const std::vector<Swing>& swings,
                        BucklingModel& model, BucklingResult& result);

}  // namespace clevis::assessment
