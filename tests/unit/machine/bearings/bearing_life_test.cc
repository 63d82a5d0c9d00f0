#include "machine/bearings/bearing_life.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "part/verdict.h"

namespace clevis::machine {
namespace {

constexpr double kPi = std::numbers::pi;

/// The bearing of the source with its assumed C0.
BearingDefinition bearing_1000096() {
  BearingDefinition bearing;
  bearing.name = "C";
  bearing.dynamic_rating = 1470.0;
  bearing.static_rating = 550.0;
  return bearing;
}

using Law = std::function<double(double)>;

std::vector<BearingInstant> history(double duration, int instants,
                                    const Law& radial, const Law& speed) {
  std::vector<BearingInstant> result;
  for (int i = 0; i < instants; ++i) {
    const double t = duration * i / (instants - 1);
    result.push_back({.t = t, .radial = radial(t), .speed = speed(t)});
  }
  return result;
}

Law constant(double value) {
  return [value](double) {
    return value;
  };
}

std::vector<std::string> codes(const BearingResult& result) {
  std::vector<std::string> list;
  for (const auto& warning : result.warnings) list.push_back(warning.code);
  return list;
}

// The source's R_r of (500, 1000) N: L10 = 2.27e6 revolutions; P0 > C0.
TEST(BearingLife, OfTheSourcesBearing) {
  const auto result = judge_bearing(
      bearing_1000096(),
      history(2.0, 21, constant(std::hypot(500.0, 1000.0)), constant(kPi)));
  EXPECT_NEAR(result.mean_load, 1118.033988749895, 1e-9);
  EXPECT_NEAR(*result.life, 1e6 * std::pow(1470.0 / 1118.033988749895, 3.0),
              1e-3);
  EXPECT_NEAR(*result.life, 2.27e6, 0.005e6);
  // one revolution in 2 s
  EXPECT_NEAR(result.travel, 2.0 * kPi, 1e-12);
  EXPECT_NEAR(*result.life_cycles / *result.life, 1.0, 1e-12);
  EXPECT_NEAR(*result.life_seconds / (2.0 * *result.life), 1.0, 1e-12);
  EXPECT_NEAR(*result.static_safety, 550.0 / 1118.033988749895, 1e-12);
  EXPECT_EQ(result.verdict, part::Verdict::kFail);
  EXPECT_EQ(codes(result), (std::vector<std::string>{"B001", "B004"}));
}

// P = P1 t/T at constant speed: P_m = P1 (1/(p + 1))^(1/p).
void expect_linear_load(BearingKind kind, double p) {
  BearingDefinition bearing = bearing_1000096();
  bearing.kind = kind;
  const auto at = [&](int instants) {
    return judge_bearing(bearing, history(
                                      3.0, instants,
                                      [](double t) {
                                        return 400.0 * t / 3.0;
                                      },
                                      constant(2.0)));
  };
  const double exact = 400.0 * std::pow(1.0 / (p + 1.0), 1.0 / p);
  const BearingResult coarse = at(101), fine = at(201);
  EXPECT_NEAR(fine.mean_load / exact, 1.0, 1e-5);
  // of second order, and bounded by what is told of the sampling
  const double error = std::abs(coarse.mean_load / exact - 1.0);
  EXPECT_NEAR(error / std::abs(fine.mean_load / exact - 1.0), 4.0, 0.01);
  EXPECT_LT(error, coarse.mean_load_error);
  EXPECT_GT(10.0 * error, coarse.mean_load_error);
  EXPECT_NEAR(*fine.life, 1e6 * std::pow(1470.0 / fine.mean_load, p), 1e-3);
}

TEST(BearingLife, MeanOfALinearLoadOnBalls) {
  expect_linear_load(BearingKind::kBall, 3.0);
}

TEST(BearingLife, MeanOfALinearLoadOnRollers) {
  expect_linear_load(BearingKind::kRoller, 10.0 / 3.0);
}

// θ = A sin wt: travels 4 A in a period; with P = P1 |cos wt|, that is
// proportional to |θ'|, P_m^3 = P1^3 ∫ c^4 / ∫ c = P1^3 (3π/16)/1.
TEST(BearingLife, OfAnOscillation) {
  const double A = 0.3, w = 2.0 * kPi;
  const auto speed = [&](double t) {
    return A * w * std::cos(w * t);
  };
  const auto load = [&](double t) {
    return 200.0 * std::abs(std::cos(w * t));
  };
  const auto result =
      judge_bearing(bearing_1000096(), history(1.0, 401, load, speed));
  EXPECT_NEAR(result.travel, 4.0 * A, 1e-4 * A);
  EXPECT_NEAR(result.swing, 2.0 * A, 1e-4 * A);
  const double exact = 200.0 * std::cbrt(3.0 * kPi / 16.0);
  EXPECT_NEAR(result.mean_load, exact, 1e-4 * exact);
  EXPECT_NEAR(*result.life_cycles, *result.life / (result.travel / (2.0 * kPi)),
              1e-6 * *result.life_cycles);
  // Turning back and forth wears like turning on.
  const auto onward =
      judge_bearing(bearing_1000096(), history(1.0, 401, load, [&](double t) {
                      return std::abs(speed(t));
                    }));
  EXPECT_EQ(onward.travel, result.travel);
  EXPECT_EQ(onward.life, result.life);
}

// Finer sampling of the same polygon of load and speed changes nothing that
// the told error does not cover; a cycle run twice has the same life.
TEST(BearingLife, DoesNotDependOnSamplingOrCycles) {
  const auto load = [](double t) {
    return 300.0 + 100.0 * std::sin(5.0 * t);
  };
  const auto speed = [](double t) {
    return 1.0 + std::sin(kPi * t);
  };
  const auto at = [&](double duration, int instants) {
    return judge_bearing(bearing_1000096(),
                         history(duration, instants, load, speed));
  };
  const BearingResult coarse = at(2.0, 101), fine = at(2.0, 1601);
  EXPECT_LT(std::abs(*coarse.life / *fine.life - 1.0), coarse.life_error);
  EXPECT_LT(std::abs(coarse.travel / fine.travel - 1.0),
            coarse.travel_error + 1e-12);
  auto twice = history(2.0, 101, load, speed);
  const auto once = twice;
  for (std::size_t i = 1; i < once.size(); ++i) {
    twice.push_back(once[i]);
    twice.back().t += 2.0;
  }
  const BearingResult doubled = judge_bearing(bearing_1000096(), twice);
  EXPECT_NEAR(*doubled.life_seconds / *coarse.life_seconds, 1.0, 0.01);
  EXPECT_NEAR(2.0 * *doubled.life_cycles / *coarse.life_cycles, 1.0, 0.01);
}

TEST(BearingLoad, EquivalentLoadsByTheirFactors) {
  BearingDefinition bearing = bearing_1000096();
  EXPECT_EQ(dynamic_equivalent(bearing, 100.0, 70.0), 100.0);
  EXPECT_EQ(static_equivalent(bearing, 100.0, 70.0), 100.0);
  bearing.dynamic_factors = AxialFactors{0.56, 1.6, 0.27};
  bearing.static_factors = AxialFactors{0.6, 0.5, 0.0};
  bearing.service_factor = 1.5;
  EXPECT_EQ(dynamic_equivalent(bearing, 100.0, 27.0), 150.0);
  EXPECT_NEAR(dynamic_equivalent(bearing, 100.0, 70.0),
              1.5 * (0.56 * 100.0 + 1.6 * 70.0), 1e-12);
  EXPECT_EQ(static_equivalent(bearing, 100.0, 70.0), 100.0);  // 95 < 100
  EXPECT_NEAR(static_equivalent(bearing, 100.0, 200.0), 160.0, 1e-12);
}

TEST(BearingVerdict, WhatTheFormulasDoNotCoverIsNotJudged) {
  auto some = history(1.0, 11, constant(100.0), constant(1.0));
  EXPECT_EQ(judge_bearing(bearing_1000096(), some).verdict,
            part::Verdict::kPass);
  auto axial = some;
  axial[5].axial = 10.0;
  auto result = judge_bearing(bearing_1000096(), axial);
  EXPECT_EQ(codes(result), (std::vector<std::string>{"B002", "B002"}));
  EXPECT_EQ(result.verdict, part::Verdict::kNotJudged);

  BearingDefinition wide = bearing_1000096();
  wide.width = 5e-3;
  auto tilted = some;
  tilted[5].tilt = 0.24;  // as if 2.4 mm beside
  EXPECT_EQ(judge_bearing(wide, tilted).verdict, part::Verdict::kPass);
  tilted[5].tilt = 0.26;
  EXPECT_EQ(codes(judge_bearing(wide, tilted)),
            std::vector<std::string>{"B005"});
  EXPECT_EQ(judge_bearing(wide, tilted).verdict, part::Verdict::kNotJudged);

  BearingDefinition strong = bearing_1000096();
  strong.static_rating = 2000.0;
  strong.life_wanted = 3600.0;
  const auto heavy = history(1.0, 11, constant(800.0), constant(1.0));
  EXPECT_EQ(codes(judge_bearing(strong, heavy)),
            std::vector<std::string>{"B004"});
  EXPECT_EQ(judge_bearing(strong, heavy).verdict, part::Verdict::kNotJudged);
}

TEST(BearingVerdict, RatingsOfNoBearingDoNotPass) {
  const auto some = history(1.0, 11, constant(100.0), constant(1.0));
  BearingDefinition bearing = bearing_1000096();
  bearing.dynamic_rating = 9.9 * bearing.static_rating;
  EXPECT_EQ(judge_bearing(bearing, some).verdict, part::Verdict::kPass);
  BearingDefinition stiff = bearing_1000096();
  stiff.static_rating = 10.1 * stiff.dynamic_rating;
  EXPECT_EQ(codes(judge_bearing(stiff, some)),
            std::vector<std::string>{"B009"});
  bearing.dynamic_rating = 1470e3;  // kN for N
  const auto result = judge_bearing(bearing, some);
  EXPECT_EQ(codes(result), std::vector<std::string>{"B009"});
  EXPECT_EQ(result.verdict, part::Verdict::kNotJudged);
}

TEST(BearingVerdict, ForceOfTeethIsMissedByName) {
  const auto some = history(1.0, 11, constant(100.0), constant(1.0));
  const auto result = judge_bearing(bearing_1000096(), some, true);
  EXPECT_EQ(codes(result), std::vector<std::string>{"B007"});
  EXPECT_EQ(result.verdict, part::Verdict::kNotJudged);
}

TEST(BearingVerdict, LifeWantedIsALimit) {
  BearingDefinition bearing = bearing_1000096();
  const auto load = history(1.0, 11, constant(500.0), constant(1.0));
  const double life = *judge_bearing(bearing, load).life_seconds;
  bearing.life_wanted = 0.999 * life;
  EXPECT_EQ(judge_bearing(bearing, load).verdict, part::Verdict::kPass);
  bearing.life_wanted = 1.001 * life;
  EXPECT_EQ(judge_bearing(bearing, load).verdict, part::Verdict::kFail);
}

TEST(BearingVerdict, JointThatDoesNotTurnHasNoLife) {
  const auto result = judge_bearing(
      bearing_1000096(), history(1.0, 11, constant(100.0), constant(1e-17)));
  EXPECT_FALSE(result.life || result.life_cycles || result.life_seconds);
  EXPECT_EQ(codes(result), std::vector<std::string>{"B003"});
  EXPECT_EQ(result.verdict, part::Verdict::kPass);
}

TEST(BearingVerdict, NoLoadHasNoBound) {
  const auto result = judge_bearing(
      bearing_1000096(), history(1.0, 11, constant(0.0), constant(1.0)));
  EXPECT_FALSE(result.life || result.static_safety);
  EXPECT_EQ(result.verdict, part::Verdict::kPass);
}

// A swing of 40° at 5 Hz for 40 s, seen 11 times in 10 s or 40 times a cycle:
// its way is 200 × 80°.
TEST(BearingLife, TurningThatIsNotFollowedIsNotJudged) {
  BearingDefinition bearing = bearing_1000096();
  bearing.static_rating = 1470.0;
  bearing.life_wanted = 1.0;
  constexpr double kSwing = kPi / 9.0, kRate = 10.0 * kPi;
  const auto swinging = [&](int instants) {
    auto seen = history(40.0, instants, constant(100.0), [&](double t) {
      return kSwing * kRate * std::cos(kRate * t);
    });
    for (BearingInstant& here : seen) {
      here.angle = kSwing * std::sin(kRate * here.t);
    }
    return judge_bearing(bearing, seen);
  };
  const auto blind = swinging(45);
  EXPECT_EQ(codes(blind), std::vector<std::string>{"B008"});
  EXPECT_EQ(blind.verdict, part::Verdict::kNotJudged);
  const auto followed = swinging(8001);
  EXPECT_EQ(followed.verdict, part::Verdict::kPass);
  EXPECT_NEAR(followed.travel, 200.0 * 4.0 * kSwing, 0.01 * followed.travel);
  EXPECT_LT(followed.travel_error, 0.02);
}

// Whole turns between two instants are no doubt where the speed says so.
TEST(BearingLife, FastTurningIsFollowed) {
  BearingDefinition bearing = bearing_1000096();
  auto seen = history(2.0, 21, constant(100.0), constant(1000.0));
  for (BearingInstant& here : seen) {
    here.angle = std::remainder(1000.0 * here.t, 2.0 * kPi);
  }
  EXPECT_LT(judge_bearing(bearing, seen).travel_error, 1e-9);
}

}  // namespace
}  // namespace clevis::machine
