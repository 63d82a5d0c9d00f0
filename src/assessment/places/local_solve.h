#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/neighbourhood.h"

namespace clevis::assessment {

/// Where a field is solved for again.
struct LocalPlace {
  std::vector<int> centre;  ///< cells, ascending
  int layers = 1;           ///< of cells around them, see mesh::surroundings
  int instant{};            ///< of the set
  int degree{};
};

/// Solves for a set's instant with a higher degree near a place; what is not
/// near is left out of the discretisation where the cells allow it.
/// @param basis  of the set, on this mesh.
/// @throws Error see elasticity::enrich.
template <int dim>
elasticity::Enriched<dim> solve_nearby(
    const PartJob& job, const LoadSet& set, const mesh::PartMesh<dim>& mesh,
    const elasticity::DisplacementBasis<dim>& basis, const LocalPlace& place);

}  // namespace clevis::assessment
