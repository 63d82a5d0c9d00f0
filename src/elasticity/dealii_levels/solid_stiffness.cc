// Compiled once for each instruction set.
#include "elasticity/dealii_levels/stiffness_operator_source.h"
#include "elasticity/engine_library/engine_library.h"

namespace clevis::elasticity {

template class StiffnessOperator<3, double>;
template class StiffnessOperator<3, float>;

CLEVIS_ENGINE_ENTRY int clevis_dealii_lanes() {
  return static_cast<int>(dealii::VectorizedArray<double>::size());
}

}  // namespace clevis::elasticity
