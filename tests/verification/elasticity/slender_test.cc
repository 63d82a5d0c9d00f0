// Slender parts: K u is a small difference of large terms, of which a factor
// of K keeps few digits. Pure bending of a prism is a polynomial of degree 2,
// exact at any slenderness. Source: docs/theory.md, "Elasticity"; anchors B6.

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/field/stress_history.h"
#include "support/field_error.h"
#include "support/structured_mesh.h"

namespace clevis {
namespace {

using Eigen::Vector3d;
using support::Vector6d;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

constexpr double kEnergy = 1e-8;  // the self-check's own bound

struct BendingErrors {
  double stress{}, energy{};
};

/// A free strip under end moments about y: σ_x = M z / I everywhere.
BendingErrors bend(double length, double width, double thickness, int degree) {
  const double stress = 100e6;  // at the surface
  const auto mesh = support::structured_mesh<3>(
      {20, 1, 1}, 1, [&](const Vector3d& x) -> Vector3d {
        return {length * x[0], width * (x[1] - 0.5), thickness * (x[2] - 0.5)};
      });
  const double modulus = width * thickness * thickness / 6.0;
  loads::LoadHistory history;
  history.instants.push_back({});
  for (const char* end : {"x0", "x1"}) {
    loads::Seat seat;
    seat.name = seat.group = end;
    seat.kind = loads::SeatKind::kTraction;
    seat.p_LS.x() = end[1] == '0' ? 0.0 : length;
    history.seats.push_back(seat);
    const double moment = (end[1] == '0' ? -1.0 : 1.0) * stress * modulus;
    history.instants[0].wrenches.push_back({Vector3d::Zero(), {0, moment, 0}});
  }
  const auto basis =
      elasticity::solve<3>({mesh, kSteel, history, {}, "strip"}, degree);
  support::ExactField exact;
  exact.stress = [&](const Vector3d& p) {
    Vector6d s = Vector6d::Zero();
    s[0] = stress * p.z() / (0.5 * thickness);
    return s;
  };
  const double energy = stress * stress * length * width * thickness /
                        (6.0 * kSteel.youngs_modulus);
  return {support::worst_stress_error(
              stress::instant_field<3>(basis, kSteel, 2, 0), exact) /
              stress,
          std::abs(basis.strain_energy[0] / energy - 1.0)};
}

// Without refinement by strains the energy check refuses from about 1:200 on,
// and what it refuses is wrong by 1e-4 at 1:1000.
TEST(Slender, PureBendingIsExactAtAnySlenderness) {
  for (const double slenderness : {10.0, 100.0, 1000.0}) {
    for (const int degree : {2, 3, 4}) {
      const double thickness = 1.0 / slenderness;
      const auto flat = bend(1.0, 0.1, thickness, degree);
      const auto needle = bend(1.0, thickness, thickness, degree);
      std::printf(
          "1:%g, degree %d: stress %.1e and %.1e, energy %.1e and %.1e\n",
          slenderness, degree, flat.stress, needle.stress, flat.energy,
          needle.energy);
      EXPECT_LT(flat.stress, 1e-7);
      EXPECT_LT(needle.stress, 1e-7);
      EXPECT_LT(flat.energy, kEnergy);
      EXPECT_LT(needle.energy, kEnergy);
    }
  }
}

}  // namespace
}  // namespace clevis
