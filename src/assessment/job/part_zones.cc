#include "assessment/job/part_zones.h"

#include <algorithm>

#include "loads/pressure/surface_shear.h"

namespace clevis::assessment {

template <int dim>
std::vector<stress::SingularZone> part_zones(const PartJob& job,
                                             const mesh::PartMesh<dim>& mesh,
                                             const LoadSet& set) {
  part::Supports held = set.fixed;
  // A bed gives way like so much of the part's own material: thinner than its
  // wall it is as good as a support.
  const double modulus = job.part.material.youngs_modulus;
  for (const auto& [group, bed] : set.foundations) {
    const double stiffness = std::max(bed.normal, bed.tangential);
    if (modulus < stiffness * job.sides()[0]) held[group] = {true, true, true};
  }
  loads::SurfaceShear shear;
  // In a plane the sequence of degrees tells what the ends of shear are worth.
  if (dim == 3) shear = loads::surface_shear(set.history, job.groups);
  return stress::singular_zones<dim>(mesh, job.part.material, held, shear);
}

template std::vector<stress::SingularZone> part_zones<2>(
    const PartJob&, const mesh::PartMesh<2>&, const LoadSet&);
template std::vector<stress::SingularZone> part_zones<3>(
    const PartJob&, const mesh::PartMesh<3>&, const LoadSet&);

}  // namespace clevis::assessment
