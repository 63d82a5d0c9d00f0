#include "assessment/impact/free_vibration.h"

#include <algorithm>

#include "stress/field/stress_history.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {

template <int dim>
FreeVibration largest_free_vibration(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material,
    const std::vector<stress::SingularZone>& zones, int from) {
  constexpr int kSubdivisions = 2;
  const auto samples = basis.coefficients.cols();
  if (from >= samples) return {};
  const Eigen::VectorXd amplitudes =
      basis.coefficients.rightCols(samples - from)
          .cwiseAbs()
          .rowwise()
          .maxCoeff();
  elasticity::DisplacementBasis<dim> shapes;
  shapes.discretization = basis.discretization;
  shapes.columns = basis.columns;
  shapes.coefficients = amplitudes.asDiagonal();
  const Eigen::MatrixXi zone_of =
      stress::zone_of_points<dim>(basis.discretization, kSubdivisions, zones);
  Eigen::ArrayXXd stress =
      Eigen::ArrayXXd::Zero(zone_of.rows(), zone_of.cols());
  Eigen::ArrayXXd way = stress;
  for (int k = 0; k < amplitudes.size(); ++k) {
    const auto field =
        stress::instant_field<dim>(shapes, material, kSubdivisions, k);
    for (Eigen::Index c = 0; c < zone_of.cols(); ++c) {
      const auto cell = static_cast<std::size_t>(c);
      stress.col(c) += stress::von_mises(field.stress[cell]).array();
      way.col(c) += field.displacement[cell].rowwise().norm().array();
    }
  }
  return {(zone_of.array() < 0).select(stress, 0.0).maxCoeff(), way.maxCoeff()};
}

template FreeVibration largest_free_vibration<2>(
    const elasticity::DisplacementBasis<2>&, const part::Material&,
    const std::vector<stress::SingularZone>&, int);
template FreeVibration largest_free_vibration<3>(
    const elasticity::DisplacementBasis<3>&, const part::Material&,
    const std::vector<stress::SingularZone>&, int);

}  // namespace clevis::assessment
