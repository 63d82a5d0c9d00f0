#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/places/meeting_places.h"
#include "assessment/places/place_band.h"
#include "elasticity/problem/displacement_basis.h"
#include "mesh/cells/part_mesh.h"
#include "stress/field/stress_history.h"

namespace clevis::assessment {

/// One set as it was solved, all of a mesh.
template <int dim>
struct SolvedSet {
  const PartJob& job;
  const LoadSet& set;
  const mesh::PartMesh<dim>& mesh;
  const elasticity::DisplacementBasis<dim>& basis;
  const stress::StressHistory& history;  ///< points below zero do not count
  int degree{};
};

/// The largest stress of some cells by finer solutions, with its error, and the
/// largest of stress and error over all these cells.
struct CloserStress {
  PlaceEstimate stress;
  stress::FieldPoint at;  ///< of the value, on the history's lattice
};

/// Whether an error beside a value [Pa] makes all further work vain.
using IsFutile = std::function<bool(double error, double value)>;

/// Solves near a place one and two degrees higher, and one degree higher with a
/// second layer of cells around, dearest last: the value is the mean of the
/// cells that meet. What degree, layer and cells differ by is its error, with
/// that of the shape of the surface and what may come from farther away.
/// @param centre  cells to look at, ascending.
/// @param pollution  what may come from outside, of the value [1].
/// @param is_futile  asked before each dear step, of what is known till then.
/// @return nothing where it was futile.
/// @throws Error see solve_nearby.
template <int dim>
std::optional<CloserStress> look_closer(const SolvedSet<dim>& solved,
                                        const Place& place,
                                        const std::vector<int>& centre,
                                        double pollution,
                                        const IsFutile& is_futile);

}  // namespace clevis::assessment
