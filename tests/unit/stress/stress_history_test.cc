#include "stress/field/stress_history.h"

#include <gtest/gtest.h>

#include "elasticity/assembly/supports.h"
#include "support/structured_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Stress of u = g x in a unit cube.
Matrix3d stress_of(const Matrix3d& g) {
  const part::Material steel{"steel", 200e9, 0.25, 7850.0, 300e6};
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = elasticity::discretize<3>(
      support::structured_mesh<3>({1, 1, 1}, 1,
                                  [](const Vector3d& x) {
                                    return x;
                                  }),
      1);
  const auto at = elasticity::node_positions(basis.discretization);
  basis.columns.resize(basis.discretization.dofs(), 1);
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    basis.columns.block<3, 1>(3 * i, 0) = g * at.col(i);
  }
  basis.coefficients = Eigen::MatrixXd::Ones(1, 1);
  return stress_tensor(instant_field<3>(basis, steel, 1, 0).stress[0].row(0));
}

// σ = λ tr ε + 2 µ ε with λ = µ = E/(2 (1 + ν)) at ν = 1/4; all six components
// differ, so that none may take another's place.
TEST(StressTensor, IsHookesOfEveryComponent) {
  Matrix3d g;
  g << 1e-4, 2e-4, 3e-4, 0.0, 5e-4, 6e-4, 0.0, 0.0, 9e-4;
  const Matrix3d strain = 0.5 * (g + g.transpose());
  const Matrix3d wanted =
      80e9 * (strain.trace() * Matrix3d::Identity() + 2.0 * strain);
  EXPECT_LT((stress_of(g) - wanted).cwiseAbs().maxCoeff(),
            1e-12 * wanted.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace clevis::stress
