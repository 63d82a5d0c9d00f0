// In one lane: plates are small.
#include "elasticity/dealii_levels/stiffness_operator_source.h"

namespace clevis::elasticity {

template class StiffnessOperator<2, double>;
template class StiffnessOperator<2, float>;

}  // namespace clevis::elasticity
