#include "dynamics/load_vibration/moving_constraints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace clevis::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;

/// A mass on a spring, whose coordinate is the first.
struct Course {
  VectorXd time;
  std::vector<MatrixXd> rows, forces;
};

/// @param rows, forces  at a time.
Course course(double duration, int instants,
              const std::function<MatrixXd(double)>& rows,
              const std::function<VectorXd(double)>& forces) {
  VectorXd time = VectorXd::LinSpaced(instants, 0.0, duration);
  std::vector<MatrixXd> all, acting;
  for (int i = 0; i < instants; ++i) {
    all.push_back(rows(time[i]));
    acting.push_back(forces(time[i]));
  }
  return {time, all, acting};
}

/// Largest of a coordinate from a time on.
double largest(const DiagonalSystem& system, const Course& course, double step,
               Eigen::Index coordinate, double from) {
  double most = 0.0;
  follow(system, SmoothPath(course.time, course.rows),
         SmoothPath(course.time, course.forces), step,
         [&](double t, const VectorXd& q) {
           if (t >= from) most = std::max(most, std::abs(q[coordinate]));
         });
  return most;
}

// Two masses of 1 and 3 kg that a constraint ties with 1 : 2 on a spring of
// 13 N/m: 1 rad/s by hand, under forces that rise from rest to 13 N.
TEST(MovingConstraints, TiedMassesSwingAsOne) {
  const DiagonalSystem system{Eigen::Vector2d(1, 3), Eigen::Vector2d::Zero(),
                              Eigen::Vector2d(13, 0)};
  const auto tied = [](double) -> MatrixXd {
    return Eigen::RowVector2d(2, -1);
  };
  // Of 2 π the rise: afterwards it stands still.
  const Course slow = course(4.0 * kPi, 801, tied, [](double t) -> VectorXd {
    return Eigen::Vector2d(13.0 * std::min(1.0, t / 2.0 / kPi), 0.0);
  });
  const auto off = [&](double step) {
    return std::abs(largest(system, slow, step, 0, 2.2 * kPi) - 1.0);
  };
  EXPECT_LT(off(0.02), 2e-3);
  EXPECT_LT(off(0.01), 0.3 * off(0.02) + 1e-4);
  EXPECT_NEAR(largest(system, slow, 0.01, 1, 2.2 * kPi), 2.0, 2e-3);
}

// A spring without mass at the end of a lever that grows slowly: the energy of
// a swing goes as its frequency, its width as the root of the period.
TEST(MovingConstraints, SwingsKeepEnergyOverFrequency) {
  const DiagonalSystem system{Eigen::Vector2d(1, 0), Eigen::Vector2d::Zero(),
                              Eigen::Vector2d(0, 1)};
  const auto lever = [](double t) {
    return 1.0 + 3.0 * std::clamp((t - 20.0) / 400.0, 0.0, 1.0);
  };
  const Course growing = course(
      500.0, 1001,
      [&](double t) -> MatrixXd {
        return Eigen::RowVector2d(lever(t), -1.0);
      },
      [](double t) -> VectorXd {
        return Eigen::Vector2d(t < 10.0 ? 1.0 : 0.0, 0.0);
      });
  const double before = [&] {
    Course first = growing;
    const auto kept = std::size_t(41);  // up to 20 s
    first.time.conservativeResize(41);
    first.rows.resize(kept);
    first.forces.resize(kept);
    return largest(system, first, 0.05, 0, 12.0);
  }();
  const double after = largest(system, growing, 0.05, 0, 440.0);
  EXPECT_NEAR(after / before, 0.5, 0.01);
}

TEST(MovingConstraints, RowsGoOnAsAParabolaBetweenUnevenInstants) {
  const auto parabola = [](double t) -> MatrixXd {
    return Eigen::RowVector2d(3.0 * t * t - t, 2.0 + t);
  };
  const VectorXd time = (VectorXd(5) << 0.0, 0.1, 1.0, 3.0, 3.5).finished();
  std::vector<MatrixXd> values;
  for (const double t : time) values.push_back(parabola(t));
  const SmoothPath rows(time, values);
  for (const Eigen::Index i : {0, 2, 3}) {
    for (const double share : {0.2, 0.5, 0.9}) {
      const double t = time[i] + share * (time[i + 1] - time[i]);
      EXPECT_LT((rows.piece(i).at(share) - parabola(t)).norm(), 1e-13);
    }
  }
  // Of straight pieces that a bend parts.
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i].setConstant(std::abs(time[Eigen::Index(i)] - 1.0));
  }
  const SmoothPath bent(time, values, 1e-9, {1.0});
  EXPECT_NEAR(bent.piece(1).at(0.5)(0, 0), 0.45, 1e-14);
  EXPECT_NEAR(bent.piece(2).at(0.5)(0, 0), 1.0, 1e-14);
}

TEST(MovingConstraints, LimitedSlopesDoNotOvershootWhereTheyBendUnseen) {
  // At rest for a second, up by 1 in a millisecond, at rest.
  const VectorXd time = (VectorXd(5) << 0.0, 1.0, 1.001, 2.0, 3.0).finished();
  std::vector<MatrixXd> values;
  for (const double value : {0.0, 0.0, 1.0, 1.0, 1.0}) {
    values.emplace_back(MatrixXd::Constant(1, 1, value));
  }
  const SmoothPath limited(time, values, 0.0, {}, SmoothPath::Slopes::kLimited);
  const SmoothPath free(time, values);
  EXPECT_EQ(limited.piece(0).at(0.7)(0, 0), 0.0);
  EXPECT_EQ(limited.piece(2).at(0.3)(0, 0), 1.0);
  EXPECT_GT(std::abs(free.piece(0).at(0.7)(0, 0)), 10.0);
}

// A pulse far shorter than a step leaves the swing of its impulse.
TEST(MovingConstraints, ShortPulsesCountByTheirImpulse) {
  const VectorXd time =
      (VectorXd(6) << 0.0, 1.0, 1.0 + 1e-5, 1.0 + 2e-5, 1.0 + 3e-5, 10.0)
          .finished();
  std::vector<MatrixXd> forces;
  for (const double f : {0.0, 0.0, 1e5, 1e5, 0.0, 0.0}) {
    forces.emplace_back(MatrixXd::Constant(1, 1, f));
  }
  const DiagonalSystem system{VectorXd::Ones(1), VectorXd::Zero(1),
                              VectorXd::Ones(1)};
  double most = 0.0;
  follow(system, SmoothPath(time, std::vector<MatrixXd>(6, MatrixXd(0, 1))),
         SmoothPath(time, forces, 0.0, {}, SmoothPath::Slopes::kOfSecants),
         0.03, [&](double, const VectorXd& q) {
           most = std::max(most, std::abs(q[0]));
         });
  EXPECT_NEAR(most, 2.0, 0.01);
}

TEST(MovingConstraints, AtRestASpringTakesWhatTheOthersLeave) {
  // Springs of 2 and 6 N/m under 4 N each, the third tied to their sum.
  const DiagonalSystem system{Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero(),
                              Eigen::Vector3d(2, 6, 0)};
  const VectorXd q =
      at_rest(system, Eigen::RowVector3d(1, 1, -1), Eigen::Vector3d(4, 4, 0));
  EXPECT_LT((q - Eigen::Vector3d(2.0, 2.0 / 3.0, 8.0 / 3.0)).norm(), 1e-6);
}

}  // namespace
}  // namespace clevis::dynamics
