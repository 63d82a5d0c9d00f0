#pragma once

#include <optional>

#include "assessment/job/part_job.h"
#include "assessment/stability/buckling_model.h"

namespace clevis::assessment {

/// Linear buckling of the part, and its shape.
struct BucklingCheck {
  BucklingResult result;
  std::optional<BucklingShape> shape;
  /// By the model's lowest_degree(); 0: not known.
  double of_lowest_degree{};
  double seconds{};
};

/// Linear buckling of a part under all its load sets, with rising degrees: all
/// instants with the first, the one that governs with the others, until the
/// limit lies outside the band. Plates by terms through their thickness, else
/// the mesh as it is. What cannot be computed (supports that hold a plate in
/// its plane only, memory) is left out, and the remark says why.
/// @throws Error of elasticity::lowest_buckling but F001, F002, F004, F007,
/// M005.
BucklingCheck check_buckling(const PartJob& job, BucklingModel& model);

}  // namespace clevis::assessment
