#include "stress/field/stress_history.h"

#include <cmath>

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

// One combination of stretching and shear at every instant, of whose stresses
// von Mises is known: σ = E ε, τ = G γ at ν = 0. Of as many instants as are
// searched in floats, each value is that of doubles, the largest in every bit.
TEST(StressHistory, OfManyInstantsIsThatOfEach) {
  const part::Material steel{"steel", 200e9, 0.0, 7850.0, 300e6};
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = elasticity::discretize<3>(
      support::structured_mesh<3>({2, 1, 1}, 1,
                                  [](const Vector3d& x) {
                                    return x;
                                  }),
      2);
  const auto at = elasticity::node_positions(basis.discretization);
  basis.columns = Eigen::MatrixXd::Zero(basis.discretization.dofs(), 2);
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    basis.columns(3 * i, 0) = 0.5e-3 * at(0, i) * at(0, i);  // σ = E x / 1000
    basis.columns(3 * i, 1) = 1e-3 * at(1, i);
  }
  constexpr Eigen::Index kInstants = 500;
  basis.coefficients.resize(2, kInstants);
  Eigen::VectorXd largest(kInstants);  // at x = 1
  for (Eigen::Index i = 0; i < kInstants; ++i) {
    const double time = 0.013 * double(i);
    basis.coefficients.col(i) << std::sin(time), 0.3 * std::cos(2.0 * time);
    largest[i] = std::hypot(200e6 * basis.coefficients(0, i),
                            std::sqrt(3.0) * 100e6 * basis.coefficients(1, i));
  }
  const auto found = stress_history<3>(basis, steel, 2);
  Eigen::Index when = 0;
  const double peak = largest.maxCoeff(&when);
  constexpr double kFloats = 1e-6, kDoubles = 1e-12;
  EXPECT_LT((found.peak - largest).cwiseAbs().maxCoeff(), kFloats * peak);
  EXPECT_NEAR(found.largest(), peak, kDoubles * peak);
  EXPECT_EQ(found.largest(), found.worst.maxCoeff());
  EXPECT_EQ(found.peak_instant, when);
  auto once = basis;
  for (Eigen::Index c = 0; c < found.worst.cols(); ++c) {
    for (Eigen::Index q = 0; q < found.worst.rows(); ++q) {
      once.coefficients = basis.coefficients.col(found.worst_instant(q, c));
      EXPECT_NEAR(stress_history<3>(once, steel, 2).worst(q, c),
                  found.worst(q, c), kDoubles * peak);
    }
  }
}

}  // namespace
}  // namespace clevis::stress
