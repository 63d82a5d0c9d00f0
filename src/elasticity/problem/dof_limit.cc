#include "elasticity/problem/dof_limit.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

void require_dofs(double dofs, DofLimit limit, const std::string& place) {
  if (!limit || dofs <= *limit) return;
  throw Error("F007", place,
              fmt::format("{:.0f} degrees of freedom, --max-dofs allows {}",
                          dofs, *limit),
              fmt::format("Give --max-dofs {:.0f} or more, or mesh the part "
                          "coarser.",
                          dofs));
}

template <int dim>
int admitted_degree(const mesh::PartMesh<dim>& mesh, int wanted,
                    DofLimit limit) {
  int degree = wanted;
  while (limit && degree > 1 && discretize<dim>(mesh, degree).dofs() > *limit) {
    --degree;
  }
  return degree;
}

template int admitted_degree<2>(const mesh::PartMesh<2>&, int, DofLimit);
template int admitted_degree<3>(const mesh::PartMesh<3>&, int, DofLimit);

}  // namespace clevis::elasticity
