#include "elasticity/dealii/dealii_solver.h"

#include "base/messages/errors.h"
#include "elasticity/engine_library/engine_library.h"

namespace clevis::elasticity {

template <int dim>
bool suits_dealii(const Discretization<dim>& discretization) {
  return discretization.shape == mesh::CellShape::kTensor &&
         !discretization.is_layer && !discretization.is_revolved &&
         discretization.thickness_degree == discretization.degree;
}

template <int dim>
void require_suits_dealii(const Discretization<dim>& discretization,
                          const std::string& place) {
  if (suits_dealii(discretization)) return;
  throw Error("F005", place,
              "the deal.II engine takes quadrangles and hexahedra only: its "
              "simplices end at straight sides and know no multigrid",
              "Leave --engine out, or mesh the part with hexahedra.");
}

template <int dim>
struct DealiiSolver<dim>::Data {
  std::unique_ptr<DealiiEngine> engine;
};

template <int dim>
DealiiSolver<dim>::DealiiSolver(const Discretization<dim>& discretization,
                                const part::Material& material,
                                const FoundationStiffness<dim>& bed,
                                const std::vector<int>& held,
                                const std::string& place, bool is_shared,
                                double most_factored)
    : data_(new Data{engine_function<DealiiEntry<dim>>(kDealiiEntry<dim>)(
          {discretization, material, bed, held, place, is_shared,
           most_factored})}) {}

template <int dim>
DealiiSolver<dim>::~DealiiSolver() = default;

template <int dim>
Eigen::MatrixXd DealiiSolver<dim>::solve(const Eigen::MatrixXd& loads) {
  return data_->engine->solve(loads);
}

template <int dim>
Eigen::MatrixXd DealiiSolver<dim>::multiply_absolute_diagonal(
    const Eigen::MatrixXd& columns) const {
  return data_->engine->multiply_absolute_diagonal(columns);
}

template <int dim>
const DealiiReport& DealiiSolver<dim>::report() const {
  return data_->engine->report();
}

template bool suits_dealii<2>(const Discretization<2>&);
template bool suits_dealii<3>(const Discretization<3>&);
template void require_suits_dealii<2>(const Discretization<2>&,
                                      const std::string&);
template void require_suits_dealii<3>(const Discretization<3>&,
                                      const std::string&);
template class DealiiSolver<2>;
template class DealiiSolver<3>;

}  // namespace clevis::elasticity
