#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "stress/zones/singular_zone.h"

namespace clevis::assessment {

/// Singular zones of a part under a load set: from its shape, its supports and,
/// of a solid mesh, the shear on its surface.
template <int dim>
std::vector<stress::SingularZone> part_zones(const PartJob& job,
                                             const mesh::PartMesh<dim>& mesh,
                                             const LoadSet& set);

}  // namespace clevis::assessment
