// Patch test on tetrahedra: uniform stress is reproduced to round-off.

#include "support/tetrahedra.h"

#include <gtest/gtest.h>

#include "stress/stress_history.h"
#include "support/elastic_field_problem.h"
#include "support/field_error.h"

namespace clevis::elasticity {
namespace {

using Eigen::Vector3d;

TEST(Tetrahedra, PatchTest) {
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  const auto mesh = support::tetrahedra(support::structured_mesh<3>(
      {2, 2, 2}, 1, [](const Vector3d& x) -> Vector3d {
        const double inside =
            x[0] * (1 - x[0]) * x[1] * (1 - x[1]) * x[2] * (1 - x[2]) * 64.0;
        return Vector3d(0.03, 0.02, 0.01)
            .cwiseProduct(x + inside * Vector3d(0.1, -0.08, 0.06));
      }));
  ASSERT_EQ(mesh.cells.size(), 48U);
  Eigen::Matrix3d stress;
  stress << 80e6, 20e6, -10e6, 20e6, -30e6, 15e6, -10e6, 15e6, 50e6;
  std::vector<support::TractionField<3>> tractions;
  for (const char* side : {"x0", "x1", "y0", "y1", "z0", "z1"}) {
    tractions.push_back({side, [&](const Vector3d&, const Vector3d& n) {
                           return Vector3d(stress * n);
                         }});
  }
  support::ExactField exact;
  exact.stress = [&](const Vector3d&) {
    support::Vector6d s;
    s << 80e6, -30e6, 50e6, 20e6, 15e6, -10e6;
    return s;
  };
  const loads::LoadHistory none;
  for (int degree : {1, 2}) {
    const auto basis = support::solve_field<3>({mesh, steel, none, {}, "block"},
                                               tractions, degree);
    EXPECT_LT(support::worst_stress_error(
                  clevis::stress::instant_field<3>(basis, steel, 2, 0), exact),
              1e-9 * 80e6)
        << "degree " << degree;
  }
}

}  // namespace
}  // namespace clevis::elasticity
