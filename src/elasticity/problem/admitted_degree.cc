#include "elasticity/problem/admitted_degree.h"

#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

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
