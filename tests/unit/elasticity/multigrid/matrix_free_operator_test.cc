#include "elasticity/multigrid/matrix_free_operator.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "elasticity/assembly/stiffness.h"
#include "support/annulus_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

/// A bent and twisted bar: no cell is like another.
mesh::PartMesh<3> twisted_bar(std::array<int, 3> divisions, int degree) {
  return support::structured_mesh<3>(
      divisions, degree, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        const double turn = 0.5 * x[0];
        return {0.2 * x[0] + 0.02 * std::sin(2.0 * x[1]),
                0.05 * (std::cos(turn) * x[1] - std::sin(turn) * x[2]),
                0.04 * (std::sin(turn) * x[1] + std::cos(turn) * x[2]) +
                    0.03 * x[0] * x[0]};
      });
}

template <typename Real>
Eigen::MatrixXd apply(const Discretization<3>& discretization, int points,
                      const Eigen::MatrixXd& x, int threads) {
  ThreadTeam team(threads);
  const auto schedule = schedule_cells(discretization);
  const auto fine = number_nodes(discretization, schedule);
  const MatrixFreeOperator<Real> stiffness(discretization, schedule, fine.table,
                                           points, lame_constants<3>(kSteel),
                                           {}, team, "part P");
  LaneVector<Real> in(fine.table.nodes);
  LaneVector<Real> out(fine.table.nodes);
  const auto each = [&](auto&& body) {
    for (int dof = 0; dof < discretization.dofs(); ++dof) {
      const int node = fine.number[static_cast<std::size_t>(dof / 3)];
      for (int lane = 0; lane < lanes::kLanes<Real>; ++lane) {
        body(dof, lane, node, dof % 3);
      }
    }
  };
  each([&](int dof, int lane, int node, int c) {
    in.at(node, c)[lane] = static_cast<Real>(x(dof, lane));
  });
  stiffness.apply(in, out);
  Eigen::MatrixXd y(x.rows(), lanes::kLanes<Real>);
  each([&](int dof, int lane, int node, int c) {
    y(dof, lane) = static_cast<double>(out.at(node, c)[lane]);
  });
  return y;
}

template <typename Real>
double distance_to_assembled(const mesh::PartMesh<3>& mesh, int degree) {
  const auto discretization = discretize<3>(mesh, degree);
  const Eigen::MatrixXd x =
      Eigen::MatrixXd::Random(discretization.dofs(), lanes::kLanes<Real>);
  const int points = degree + (discretization.geometry_degree > 1 ? 2 : 1);
  const Eigen::MatrixXd wanted =
      assemble_stiffness(discretization, kSteel, "part P").multiply(x);
  return (apply<Real>(discretization, points, x, 2) - wanted).norm() /
         wanted.norm();
}

TEST(MatrixFreeOperator, EqualsTheAssembledMatrixOnCurvedCells) {
  for (int degree = 1; degree <= 4; ++degree) {
    EXPECT_LT(distance_to_assembled<double>(twisted_bar({5, 3, 2}, 3), degree),
              1e-13)
        << degree;
    EXPECT_LT(distance_to_assembled<float>(twisted_bar({5, 3, 2}, 3), degree),
              1e-5)
        << degree;
  }
}

TEST(MatrixFreeOperator, EqualsTheAssembledMatrixWhereCellsTurn) {
  // Sewn together, the ring's cells don't all lie the same way.
  const support::Annulus ring{.inner = 0.01,
                              .outer = 0.02,
                              .thickness = 0.008,
                              .radial = 2,
                              .angular = 9,
                              .axial = 2};
  for (int degree = 1; degree <= 4; ++degree) {
    EXPECT_LT(
        distance_to_assembled<double>(support::ring_mesh<3>(ring), degree),
        1e-13)
        << degree;
  }
}

TEST(MatrixFreeOperator, SameBitsForAnyNumberOfThreads) {
  const auto discretization = discretize<3>(twisted_bar({9, 4, 3}, 2), 3);
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(discretization.dofs(), 8);
  const Eigen::MatrixXd one = apply<double>(discretization, 5, x, 1);
  for (int threads : {2, 4}) {
    const Eigen::MatrixXd more = apply<double>(discretization, 5, x, threads);
    EXPECT_EQ(
        std::memcmp(one.data(), more.data(),
                    sizeof(double) * static_cast<std::size_t>(one.size())),
        0)
        << threads;
  }
}

TEST(MatrixFreeOperator, IsSymmetric) {
  const auto discretization = discretize<3>(twisted_bar({4, 3, 3}, 2), 2);
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(discretization.dofs(), 8);
  const Eigen::MatrixXd y = Eigen::MatrixXd::Random(discretization.dofs(), 8);
  const Eigen::MatrixXd yKx =
      y.transpose() * apply<double>(discretization, 4, x, 2);
  const Eigen::MatrixXd xKy =
      x.transpose() * apply<double>(discretization, 4, y, 2);
  EXPECT_LT((yKx - xKy.transpose()).norm(), 1e-13 * yKx.norm());
}

TEST(MatrixFreeOperator, RefusesFoldedCells) {
  auto mesh = twisted_bar({2, 2, 2}, 2);
  mesh.cell_points[5].col(13) += Eigen::Vector3d(0.1, 0.0, 0.0);
  const auto discretization = discretize<3>(mesh, 2);
  try {
    apply<double>(discretization, 4,
                  Eigen::MatrixXd::Zero(discretization.dofs(), 8), 2);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "M005");
    EXPECT_NE(error.problem().find("cell 5"), std::string::npos);
  }
}

}  // namespace
}  // namespace clevis::elasticity
