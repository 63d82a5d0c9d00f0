#pragma once

#include <cstddef>
#include <vector>

#include "assessment/job/part_job.h"
#include "mesh/cells/part_mesh.h"
#include "stress/zones/singular_zone.h"

namespace clevis::assessment {

/// The singular zones of a plate's plane model; for dim = 3 through the
/// thickness.
template <int dim>
std::vector<stress::SingularZone> plate_zones(const PartJob& job,
                                              const mesh::PartMesh<2>& plate,
                                              const LoadSet& set);

/// The instants that govern a part: of each load set those whose peaks, by
/// plane stress or a few thickness terms of a low degree, come near to the
/// largest of all. A handful, so that models are compared at little cost.
std::vector<LoadSet> governing_loads(const PartJob& job,
                                     const mesh::PartMesh<2>& plate,
                                     bool in_plane);

/// How far the peak by plane stress is from that of 3-D elasticity, measured
/// with thickness terms of the same degree; over the peak [1].
double plane_stress_error(const PartJob& job, const mesh::PartMesh<2>& plate,
                          const std::vector<LoadSet>& governing);

/// Whether two terms of a low degree already say that plane stress cannot meet
/// the tolerance: the cheap part of plane_stress_error().
bool plane_stress_is_far(const PartJob& job, const mesh::PartMesh<2>& plate,
                         const std::vector<LoadSet>& governing);

/// Whether terms through the thickness take longer than 3-D elasticity does,
/// and more than some seconds, by the flops of their factorisations.
bool terms_cost_more(const PartJob& job, const mesh::PartMesh<2>& plate);

/// Thickness terms and what is still missing with them.
struct ThicknessChoice {
  int terms{};
  double model_error{};  ///< over the peak [1]
};

/// The fewest terms whose peak differs from those with one and with two more
/// by less than `allowed` [1] of it; the highest number of terms if none does.
/// One more alone may agree by chance. More terms, compared by a higher degree,
/// where pressures have a kink within the thickness.
/// @param is_pressed_through  as of PlateShape.
ThicknessChoice choose_terms(const PartJob& job, const mesh::PartMesh<2>& plate,
                             const std::vector<LoadSet>& governing,
                             bool is_pressed_through, double allowed);

/// What a plate's few layers of hexahedra miss of pressures with a kink within
/// the thickness: as much as their terms do; over the peak [1].
double kink_error(const PartJob& job, const mesh::PartMesh<2>& plate,
                  const std::vector<LoadSet>& governing, std::size_t layers);

}  // namespace clevis::assessment
