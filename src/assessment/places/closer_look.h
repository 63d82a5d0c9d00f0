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
  int instant{};          ///< of the value's solution
};

/// What is known of a place before its dearest solution.
struct KnownOfPlace {
  double error{};    ///< at least [Pa]
  double lasting{};  ///< of it what no degree mends: the surface's shape [Pa]
  /// With a guess of what is not solved for; nothing before the first solution.
  std::optional<PlaceEstimate> estimate;
};

/// What that is worth.
enum class Worth {
  kMore,    ///< the dearest solution as well
  kEnough,  ///< the guess will do: no answer hangs on it
  kNothing  ///< all further work is vain
};

/// Asked before each dear step.
using WorthOf = std::function<Worth(const KnownOfPlace&)>;

/// Solves near a place one and two degrees higher, and one degree higher with a
/// second layer of cells around, dearest last: the value is the mean of the
/// cells that meet. What degree, layer and cells differ by is its error, with
/// that of the shape of the surface and what may come from farther away. Where
/// the second layer is not worth it, it counts as far off as the degree.
///
/// It does so at the place's instant. What other points rise by to their own
/// worst instants is added from the given solution and, for it is not solved
/// for, in the lower end; where that is much, their instants are looked at too.
/// @param centre  cells to look at, ascending.
/// @param pollution  what may come from outside, of the value [1].
/// @return nothing where that was worth nothing.
/// @throws Error see solve_nearby.
template <int dim>
std::optional<CloserStress> look_closer(const SolvedSet<dim>& solved,
                                        const Place& place,
                                        const std::vector<int>& centre,
                                        double pollution,
                                        const WorthOf& worth_of);

}  // namespace clevis::assessment
