// Vibration about the quasi-static answer to a load history against closed
// forms. Source: docs/theory.md, "Vibration under a load history".

#include "dynamics/load_vibration/load_answer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "dynamics/load_vibration/load_shapes.h"
#include "support/dense_system.h"

namespace clevis {
namespace {

using dynamics::LoadAnswer;
using dynamics::LoadPath;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kPi = std::numbers::pi;

struct Knot {
  double t, value;
};

LoadPath path_of(const std::vector<Knot>& knots) {
  const auto n = static_cast<Index>(knots.size());
  VectorXd time(n);
  MatrixXd values(1, n);
  for (Index i = 0; i < n; ++i) {
    time[i] = knots[static_cast<std::size_t>(i)].t;
    values(0, i) = knots[static_cast<std::size_t>(i)].value;
  }
  return {time, values, 1e-12};
}

/// A mode of unit period under a load that deflects it by the path's value.
LoadAnswer answer(const LoadPath& path, double damping = 0.0) {
  const double end = path.time()[path.size() - 1];
  const VectorXd others = VectorXd::LinSpaced(static_cast<Index>(4000.0 * end),
                                              path.time()[0], end);
  return dynamics::answer_to(path, MatrixXd::Ones(1, 1),
                             VectorXd::Constant(1, 4.0 * kPi * kPi),
                             dynamics::ModeDamping::even(damping, 1), others);
}

double largest(const LoadAnswer& answer) {
  return (answer.path + answer.added).maxCoeff();
}

/// Both sides of 0 and of the end, the pulse at even instants, rest.
LoadPath pulse(double duration, int intervals,
               const std::function<double(double)>& shape, double rest) {
  std::vector<Knot> knots{{0.0, 0.0}};
  for (int i = 0; i <= intervals; ++i) {
    const double t = duration * i / intervals;
    knots.push_back({t, shape(t / duration)});
  }
  knots.push_back({duration, shape(1.0)});
  knots.push_back({duration + rest, shape(1.0)});
  return path_of(knots);
}

// Triangles of three periods, known at their corners: straight in between, for
// they are known to bend there. Their third wave swings with the mode.
TEST(LoadPath, IsStraightBetweenBends) {
  constexpr Index kEdges = 12, kEach = 10;
  constexpr double kEdge = 1.5;  // periods
  const auto triangles = [&](Index each) {
    const Index n = kEdges * each + 1;
    MatrixXd values(1, n);
    for (Index i = 0; i < n; ++i) {
      const Index edge = i / each;
      const double share =
          static_cast<double>(i % each) / static_cast<double>(each);
      values(0, i) = edge % 2 == 0 ? share : 1.0 - share;
    }
    return values;
  };
  const auto times = [&](Index each) {
    return VectorXd::LinSpaced(kEdges * each + 1, 0.0, kEdges * kEdge).eval();
  };
  const VectorXd corners = times(1);
  const std::vector<double> bends(corners.begin(), corners.end());
  const LoadPath table(times(kEach), triangles(kEach), 1e-12,
                       LoadPath::Between::kLinear);
  const double truth = largest(answer(table));
  const LoadPath sparse(corners, triangles(1), 1e-12, LoadPath::Between::kCubic,
                        bends);
  EXPECT_NEAR(largest(answer(sparse)), truth, 1e-3);
  EXPECT_EQ(thinned(sparse).size(), sparse.size());
  EXPECT_NEAR(largest(answer(thinned(sparse))), truth, 1e-3);
  // Not told of the bends, it rounds them.
  const LoadPath rounded(corners, triangles(1), 1e-12);
  EXPECT_GT(truth, 1.5 * largest(answer(rounded)));
}

TEST(LoadAnswer, StepIsAnsweredTwice) {
  const auto path = path_of({{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {2.75, 1.0}});
  const LoadAnswer found = answer(path);
  for (Index i = 0; i < found.time.size(); ++i) {
    if (found.time[i] < 0.5 || found.path(0, i) < 1.0) continue;
    EXPECT_NEAR(found.path(0, i) + found.added(0, i),
                1.0 - std::cos(2.0 * kPi * (found.time[i] - 0.5)), 1e-12);
    EXPECT_NEAR(found.energy[i], 0.5 * 4.0 * kPi * kPi, 1e-10);
  }
}

TEST(LoadAnswer, DampedStepOvershoots) {
  const double zeta = 0.05;
  const auto path = path_of({{0.0, 0.0}, {0.0, 1.0}, {2.0, 1.0}});
  EXPECT_NEAR(largest(answer(path, zeta)),
              1.0 + std::exp(-kPi * zeta / std::sqrt(1.0 - zeta * zeta)), 1e-6);
}

// 1 + |sin(π t_rise)|/(π t_rise), exactly: a ramp is cubic.
TEST(LoadAnswer, RampSpectrum) {
  for (const double rise : {0.05, 0.3, 0.75, 1.0, 1.5, 4.3}) {
    const auto path = pulse(
        rise, 1,
        [](double s) {
          return s;
        },
        2.0);
    EXPECT_NEAR(largest(answer(path)),
                1.0 + std::abs(std::sin(kPi * rise)) / (kPi * rise), 1e-6)
        << rise;
  }
}

/// Largest displacement under sin(π t/r), 0 <= t <= r, and after it.
double half_sine(double r) {
  const double a = 0.5 / r, scale = 1.0 / (1.0 - a * a);
  double top = 0.0;
  for (int i = 0; i <= 20000; ++i) {
    const double t = r * i / 20000.0;
    top = std::max(
        top, scale * (std::sin(kPi * t / r) - a * std::sin(2.0 * kPi * t)));
  }
  const double end = -scale * a * std::sin(2.0 * kPi * r);
  const double rate =
      scale * (-kPi / r - 2.0 * kPi * a * std::cos(2.0 * kPi * r));
  return std::max(top, std::hypot(end, rate / (2.0 * kPi)));
}

TEST(LoadAnswer, HalfSineSpectrum) {
  const auto shape = [](double s) {
    return std::sin(kPi * s);
  };
  for (const double r : {0.05, 0.25, 0.81, 1.7, 6.0}) {
    EXPECT_NEAR(largest(answer(pulse(r, 60, shape, 1.5))), half_sine(r), 1e-3)
        << r;
  }
  EXPECT_NEAR(half_sine(0.81), 1.77, 0.005);
}

// What every second instant less does tells what is missed between them.
TEST(LoadAnswer, ThinnedPathTellsTheErrorBetweenInstants) {
  const auto shape = [](double s) {
    return std::sin(kPi * s);
  };
  const double r = 0.81, exact = half_sine(r);
  const LoadPath path = pulse(r, 16, shape, 1.0), half = thinned(path);
  EXPECT_EQ(half.size(), path.size() - 8);
  const double error = std::abs(largest(answer(path)) - exact);
  const double change = std::abs(largest(answer(path)) - largest(answer(half)));
  EXPECT_GT(change, error);
  EXPECT_LT(change, 0.05 * exact);
}

// Smooth loads with instants ten periods apart shake nothing.
TEST(LoadAnswer, SlowLoadsAreQuasiStatic) {
  std::vector<Knot> knots;
  for (int i = 0; i <= 40; ++i) {
    knots.push_back({10.0 * i, std::sin(0.01 * i * i)});
  }
  const LoadAnswer found = answer(path_of(knots));
  EXPECT_LT(found.added.cwiseAbs().maxCoeff(), 1e-3);
}

// q'' + 2 ζ ω q' + ω² q = ω² x on the path's own cubics, by small steps of
// Heun's rule.
TEST(LoadAnswer, DampedCubicsAgainstSmallSteps) {
  const double zeta = 0.3, omega = 2.0 * kPi;
  const auto path =
      path_of({{0.0, 0.0}, {0.0, 0.3}, {0.7, 1.0}, {1.1, 1.2}, {1.9, -0.4}});
  const auto found = dynamics::answer_to(
      path, MatrixXd::Ones(1, 1), VectorXd::Constant(1, omega * omega),
      dynamics::ModeDamping::even(zeta, 1), VectorXd(0));
  constexpr int kSteps = 20000;
  double q = 0.0, v = 0.0;
  for (Index i = 1; i + 1 < path.size(); ++i) {
    const MatrixXd a = path.cubic(i);
    const double h = (path.time()[i + 1] - path.time()[i]) / kSteps;
    const auto push = [&](double t, double q_t, double v_t) {
      const double x =
          path.values()(0, i) + t * (a(0, 0) + t * (a(0, 1) + t * a(0, 2)));
      return omega * omega * (x - q_t) - 2.0 * zeta * omega * v_t;
    };
    for (int k = 0; k < kSteps; ++k) {
      const double first = push(k * h, q, v);
      const double second = push((k + 1) * h, q + h * v, v + h * first);
      q += h * (v + 0.5 * h * first);
      v += 0.5 * h * (first + second);
    }
    EXPECT_NEAR(found.path(0, i + 1) + found.added(0, i + 1), q, 1e-6);
  }
}

// Two modes on a damper that holds both, strong enough to move the first,
// against small steps of Heun's rule: w'' + C w' + ω² w = −x''.
TEST(LoadAnswer, DampersCoupleModes) {
  const Eigen::Vector2d omega(2.0 * kPi, 5.0 * kPi), along(2.0, 3.0);
  const Eigen::Matrix2d dampers = along * along.transpose();
  const auto path = path_of({{0.0, 0.0}, {0.7, 1.0}, {1.1, 1.2}, {1.9, -0.4}});
  const MatrixXd shares = Eigen::Vector2d(1.0, -0.5);
  const auto found =
      dynamics::answer_to(path, shares, omega.cwiseAbs2(),
                          {Eigen::ArrayXd::Zero(2), dampers}, VectorXd(0));
  constexpr int kSteps = 20000;
  Eigen::Vector2d w = Eigen::Vector2d::Zero(), v = w;
  for (Index i = 0; i + 1 < path.size(); ++i) {
    const MatrixXd a = path.cubic(i);
    const double h = (path.time()[i + 1] - path.time()[i]) / kSteps;
    v -= shares * path.bend(i);
    const auto push = [&](double t, const Eigen::Vector2d& w_t,
                          const Eigen::Vector2d& v_t) -> Eigen::Vector2d {
      return -shares * (2.0 * a(0, 1) + 6.0 * a(0, 2) * t) - dampers * v_t -
             omega.cwiseAbs2().cwiseProduct(w_t);
    };
    for (int k = 0; k < kSteps; ++k) {
      const Eigen::Vector2d first = push(k * h, w, v);
      const Eigen::Vector2d second =
          push((k + 1) * h, w + h * v, v + h * first);
      w += h * (v + 0.5 * h * first);
      v += 0.5 * h * (first + second);
    }
    for (Index mode = 0; mode < 2; ++mode) {
      EXPECT_NEAR(found.added(mode, i + 1), w[mode], 1e-6);
    }
  }
}

// Within a jump it is looked at as behind it: what a strong damper takes away
// in no time would grow backwards as fast.
TEST(LoadAnswer, LooksWithinAJumpOfWhatIsDamped) {
  const double width = 1e-6;
  Eigen::VectorXd time(4);
  time << 0.0, 0.5, 0.5 + width, 1.0;
  const Eigen::RowVector4d values(0.0, 0.0, 1.0, 1.0);
  const dynamics::LoadPath path(time, values, 2.0 * width);
  ASSERT_TRUE(path.is_jump(1));
  const VectorXd looks = VectorXd::Constant(1, 0.5 + 0.1 * width);
  const auto found = dynamics::answer_to(
      path, MatrixXd::Ones(1, 1), VectorXd::Constant(1, 4.0 * kPi * kPi),
      {Eigen::ArrayXd::Zero(1), MatrixXd::Constant(1, 1, 5e7)}, looks);
  for (const double added : found.added.reshaped()) {
    EXPECT_LE(std::abs(added), 1.0 + 1e-6);
  }
  EXPECT_NEAR(found.added(0, 3), -1.0, 1e-6);
}

// A damper drags on a load that rises evenly: w' of the load is not zero.
TEST(LoadAnswer, DampedRampLagsBehind) {
  const double zeta = 0.2, rise = 30.0;
  const auto path = pulse(
      rise, 1,
      [](double s) {
        return s;
      },
      0.1);
  const LoadAnswer found = answer(path, zeta);
  const double lag = 2.0 * zeta / (2.0 * kPi) / rise;
  Index at = 0;
  while (found.time[at] < 29.0) ++at;
  EXPECT_NEAR(found.added(0, at), -lag, 1e-9);
}

// A jump spread by a bell curve: of the swing after it, at rest before, the
// curve's Fourier transform is left.
TEST(LoadAnswer, SpreadJumpSwingsLess) {
  const double front = 0.2, omega = 2.0 * kPi;
  const auto path = path_of({{0.0, 0.0}, {0.0, 1.0}, {3.0, 1.0}});
  const auto found = dynamics::answer_to(
      path, MatrixXd::Ones(1, 1), VectorXd::Constant(1, omega * omega),
      dynamics::ModeDamping::even(0.0, 1), VectorXd::LinSpaced(3001, 0.0, 3.0),
      front);
  const double left = std::exp(-0.5 * std::pow(omega * front, 2));
  EXPECT_NEAR(found.added.row(0).maxCoeff(), left, 1e-6);
  EXPECT_NEAR(found.added.row(0).minCoeff(), -left, 1e-6);
  EXPECT_NEAR(found.added(0, 2), -left, 1e-12);  // just behind the jump

  // Where only the rate jumps: by 1 a period, after a ramp without swing.
  const auto bend = dynamics::answer_to(
      path_of({{0.0, 0.0}, {1.0, 1.0}, {1.0, 1.0}, {4.0, 1.0}}),
      MatrixXd::Ones(1, 1), VectorXd::Constant(1, omega * omega),
      dynamics::ModeDamping::even(0.0, 1), VectorXd::LinSpaced(4001, 0.0, 4.0),
      front);
  EXPECT_NEAR(bend.added.row(0).maxCoeff(), left / omega, 1e-6);
}

// The rod held at its first end, pulled at the other by a step: its end's
// displacement is a triangle wave between 0 and twice the static one.
// A ramp of one period leaves no swing: the cubics keep its bends, wherever the
// instants lie.
TEST(LoadAnswer, BendsAreKept) {
  std::vector<Knot> knots;
  for (int i = 0; i <= 60; ++i) {
    const double t = 0.1 * i;
    knots.push_back({t, std::min(1.0, std::max(0.0, t - 2.0))});
  }
  const LoadAnswer found = answer(path_of(knots));
  EXPECT_NEAR(found.added.row(0).maxCoeff(), 1.0 / (2.0 * kPi), 1e-6);
  EXPECT_NEAR(largest(found), 1.0, 1e-9);
}

// A ramp of r periods from the first instant on answers as one that begins
// later: 1 + |sin(π r)|/(π r).
TEST(LoadAnswer, LoadsStandStillBeforeTheFirstInstant) {
  for (const double r : {0.3, 1.5}) {
    const auto found =
        answer(path_of({{0.0, 0.0}, {r, 1.0}, {r, 1.0}, {r + 4.0, 1.0}}));
    EXPECT_NEAR(largest(found), 1.0 + std::abs(std::sin(kPi * r)) / (kPi * r),
                1e-6);
  }
}

// Rows of a file: a triangle in three of them, no cubic between.
TEST(LoadPath, RowsOfAFileAreLinearBetween) {
  VectorXd time(4);
  time << 0.0, 1.0, 3.0, 4.0;
  MatrixXd values(1, 4);
  values << 0.0, 1.0, -1.0, 0.0;
  const LoadPath path(time, values, 1e-12, LoadPath::Between::kLinear);
  for (const double t : {0.25, 1.5, 2.9, 3.5}) {
    const double exact = t < 1.0 ? t : t < 3.0 ? 2.0 - t : t - 4.0;
    EXPECT_NEAR(path.at(t)[0], exact, 1e-12);
  }
  EXPECT_NEAR(path.bend(1)[0], -2.0, 1e-12);
  EXPECT_EQ(dynamics::thinned(path).size(), 4);
}

// Of a few instants between two events none can be spared.
TEST(LoadPath, ThinnedKeepsShortPiecesWhole) {
  std::vector<Knot> knots{{0.0, 0.0}, {0.4, 0.2}, {1.0, 1.0}, {1.0, 0.0}};
  for (int i = 1; i <= 8; ++i) knots.push_back({1.0 + i, std::sin(i)});
  const auto thin = dynamics::thinned(path_of(knots));
  ASSERT_EQ(thin.size(), 3 + 5);
  EXPECT_EQ(thin.time()[1], 0.4);
  EXPECT_EQ(thin.time()[4], 3.0);
}

// Of a step nothing, of a triangle the mean of its tip's fall, τ √(2/π) over
// half its base, and of a pulse far shorter than τ nearly all.
TEST(LoadAnswer, CutBySpread) {
  const double front = 0.01;
  const auto cut = [&](const std::vector<Knot>& knots) {
    return dynamics::cut_by_spread(path_of(knots), MatrixXd::Ones(1, 1),
                                   VectorXd::Ones(1), front);
  };
  EXPECT_EQ(cut({{0, 0}, {1, 0}, {1, 1}, {2, 1}}), 0.0);
  const auto triangle = [](double half) {
    return std::vector<Knot>{{0, 0},
                             {1, 0},
                             {1, 0},
                             {1 + half, 1},
                             {1 + half, 1},
                             {1 + 2 * half, 0},
                             {1 + 2 * half, 0},
                             {2, 0}};
  };
  EXPECT_NEAR(cut(triangle(0.1)), 0.1 * std::sqrt(2.0 / kPi), 0.02);
  EXPECT_GT(cut(triangle(0.001)), 0.8);
  EXPECT_EQ(cut(triangle(0.5)), 0.0);  // gentle
}

TEST(LoadShapes, StepOnARod) {
  const support::UnitRod rod(40);
  VectorXd load = VectorXd::Zero(rod.system.size);
  load[load.size() - 1] = 1.0;
  const MatrixXd statics = rod.system.factor(0.0)(load);
  dynamics::LoadShapes space(rod.system, statics);
  const auto shapes = space.shapes(60);
  const MatrixXd participation =
      shapes.columns.transpose() * rod.system.mass(statics);
  const auto path = path_of({{0.0, 0.0}, {0.0, 1.0}, {4.0, 1.0}});
  const VectorXd others = VectorXd::LinSpaced(401, 0.0, 4.0);
  const auto found = dynamics::answer_to(
      path, participation, shapes.squares,
      dynamics::ModeDamping::even(0.0, shapes.squares.size()), others);
  const Index end = load.size() - 1;
  for (Index i = 1; i < found.time.size(); ++i) {
    const double t = found.time[i];
    const double u = statics(end, 0) * found.path(0, i) +
                     shapes.columns.row(end).dot(found.added.col(i));
    if (i == 1) continue;  // before the step
    EXPECT_NEAR(u, t < 2.0 ? t : 4.0 - t, 6e-3) << t;
  }
}

}  // namespace
}  // namespace clevis
