#include "assessment/pace/load_pace.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "assessment/pace/spinning_part.h"
#include "assessment/part_check.h"
#include "unit/assessment/pulled_bar.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

/// A bar about x whose weight turns in its frame for three turns.
PartJob turning(double depth, double speed) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  job.mesh = support::structured_mesh<3>(
      {20, 2, 2}, 1, [&](const Vector3d& x) -> Vector3d {
        return Vector3d(kSize.x(), depth, kSize.z())
            .cwiseProduct(x - Vector3d(0.0, 0.5, 0.5));
      });
  job.mass = mesh::mass_properties(job.mesh, kCork.density);
  constexpr int kPerTurn = 40, kTurns = 3;
  auto& instants = job.load_sets.front().history.instants;
  instants.clear();
  for (int i = 0; i <= kPerTurn * kTurns; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPerTurn;
    loads::InstantLoad instant;
    instant.time = angle / speed;
    instant.rigid.omega = speed * Vector3d::UnitX();
    instant.rigid.acceleration =
        9.81 * Vector3d(0.0, std::cos(angle), -std::sin(angle));
    instants.push_back(instant);
  }
  return job;
}

// What stands in space excites nothing of an even section; an uneven one sags
// twice a turn more and less, at its frequency where it spins at half of that.
TEST(LoadPace, WeightOfAPartThatSpins) {
  constexpr double kFirst = 1e-3;  // period [s]
  const double frequency = 2.0 * std::numbers::pi / kFirst;
  const auto stands = [&](double depth, double share) {
    const PartJob job = turning(depth, share * frequency);
    EXPECT_TRUE(spins_fast(job, job.load_sets.front(), kFirst));
    return stand_in_space(job, job.load_sets.front(), kFirst);
  };
  for (const double share : {0.05, 0.5, 0.7}) {
    EXPECT_TRUE(stands(kSize.z(), share)) << share;
  }
  EXPECT_TRUE(stands(2.0 * kSize.z(), 0.05));
  EXPECT_FALSE(stands(2.0 * kSize.z(), 0.5));
  EXPECT_FALSE(stands(2.0 * kSize.z(), 0.4));
  // A pull that stands in its frame beside the weight; one that does not.
  PartJob pulled_too = turning(kSize.z(), 0.5 * frequency);
  auto& instants = pulled_too.load_sets.front().history.instants;
  for (auto& instant : instants) instant.rigid.acceleration.y() += 30.0;
  EXPECT_TRUE(stand_in_space(pulled_too, pulled_too.load_sets.front(), kFirst));
  for (auto& instant : instants) {
    instant.rigid.acceleration.z() += 3.0 * std::sin(frequency * instant.time);
  }
  EXPECT_FALSE(
      stand_in_space(pulled_too, pulled_too.load_sets.front(), kFirst));
}

// A shake is not small because a large force stands still beside it.
TEST(LoadPace, ASteadyForceHidesNoShakeOfAPartThatSpins) {
  constexpr double kFirst = 1e-3;  // period [s]
  const double frequency = 2.0 * std::numbers::pi / kFirst;
  PartJob job = turning(kSize.z(), 0.5 * frequency);
  auto& instants = job.load_sets.front().history.instants;
  for (auto& instant : instants) instant.rigid.acceleration.x() += 1e7;
  EXPECT_TRUE(stand_in_space(job, job.load_sets.front(), kFirst));
  for (auto& instant : instants) {
    instant.rigid.acceleration.z() += 3.0 * std::sin(frequency * instant.time);
  }
  EXPECT_FALSE(stand_in_space(job, job.load_sets.front(), kFirst));
}

// A cantilever's ω² rises by 1.19 Ω² across its plane of turning, 1.57 more for
// each length that its root is away from the axis.
TEST(LoadPace, TurningAcrossItsLengthMovesAPartsFrequency) {
  constexpr double kFirst = 1e-3;  // period [s]
  const double frequency = 2.0 * std::numbers::pi / kFirst;
  PartJob job = turning(kSize.z(), 0.3 * frequency);
  EXPECT_EQ(turning_part(job, job.load_sets.front(), kFirst).shift, 0.0);
  const double length = job.sides()[2];
  for (const double arm : {0.0, 2.0}) {
    for (auto& instant : job.load_sets.front().history.instants) {
      const double turn = 0.3 * frequency;
      instant.rigid.omega = turn * Vector3d::UnitZ();
      instant.rigid.acceleration =
          -turn * turn * arm * length * Vector3d::UnitX();
    }
    const auto part = turning_part(job, job.load_sets.front(), kFirst);
    EXPECT_NEAR(part.speed, 0.3, 1e-9);
    const double theory = 0.3 * 0.3 * (1.19 + 1.57 * arm);
    EXPECT_GE(part.shift, theory);
    EXPECT_LE(part.shift, 1.06 * theory);
  }
}

// A sine a tenth above the first frequency, which it would meet.
TEST(LoadPace, OscillatorsNearTheFirstMeetTheLoad) {
  constexpr double kFirst = 1e-3;  // period [s]
  PartJob job = turning(kSize.z(), 1.1 * 2.0 * std::numbers::pi / kFirst);
  job.part.damping = 0.01;
  const auto components = load_components(job, job.load_sets.front());
  EXPECT_EQ(rise_near(job, components, kFirst, 1.0, 1.0), 1.0);
  EXPECT_LT(rise_near(job, components, kFirst, 0.8, 1.0), 1.05);
  EXPECT_GT(rise_near(job, components, kFirst, 1.0, 1.3), 1.3);
  const double beside = rise_near(job, components, kFirst, 1.19, 1.23);
  EXPECT_NEAR(rise_near(job, components, kFirst, 0.05, 9.0), beside,
              0.01 * beside);
}

/// The loads and the mass in a frame turned by `turn` and moved by `shift`.
PartJob seen_from(PartJob job, const Eigen::Matrix3d& turn,
                  const Vector3d& shift) {
  job.mass.p_LCm = turn * job.mass.p_LCm + shift;
  for (auto& instant : job.load_sets.front().history.instants) {
    for (auto& wrench : instant.wrenches) {
      wrench = {turn * wrench.force, turn * wrench.moment};
    }
    for (auto& load : instant.surface_loads) {
      auto& [force, moment] = load.resultant;
      force = turn * force;
      moment = turn * moment + shift.cross(force);
    }
    auto& rigid = instant.rigid;
    rigid.alpha = turn * rigid.alpha;
    rigid.omega = turn * rigid.omega;
    rigid.acceleration = turn * rigid.acceleration - rigid.alpha.cross(shift) -
                         rigid.omega.cross(rigid.omega.cross(shift));
  }
  return job;
}

// Components are along axes of the loads: the part's frame counts for nothing.
TEST(LoadPace, ComponentsAreThoseOfAnyFrame) {
  PartJob job = bar(transit());
  auto& instants = job.load_sets.front().history.instants;
  instants.clear();
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.1 * i;
    loads::InstantLoad instant = pulled(t * transit(), std::sin(t));
    instant.wrenches = {{{std::sin(t), 0.1 * std::cos(3.0 * t), 0.01 * t * t},
                         {t, std::exp(-t), 0.0}}};
    loads::SurfaceLoad pressed;
    pressed.resultant = {Vector3d(0.0, t, 1.0), Vector3d(std::sin(t), 0.0, t)};
    pressed.total = t;
    instant.surface_loads = {pressed};
    instant.rigid.acceleration = Vector3d(std::cos(t), t, 0.0);
    instant.rigid.alpha = Vector3d(0.0, t, std::sin(2.0 * t));
    instant.rigid.omega = Vector3d(std::sin(t), 1.0, 0.3 * t);
    instants.push_back(instant);
  }
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.0, Vector3d(1.0, -2.0, 0.5).normalized())
          .toRotationMatrix();
  const auto components = [](const PartJob& one) {
    return load_components(one, one.load_sets.front()).values();
  };
  const Eigen::MatrixXd here = components(job);
  EXPECT_GT(here.rows(), 18);
  const Eigen::Matrix3d mirrored = turn * Vector3d(1.0, -1.0, 1.0).asDiagonal();
  const Eigen::MatrixXd there =
      components(seen_from(job, turn, Vector3d(0.1, -0.2, 0.05)));
  ASSERT_EQ(there.rows(), here.rows());
  EXPECT_LT((there.cwiseAbs() - here.cwiseAbs()).lpNorm<Eigen::Infinity>(),
            1e-9);
  // Moments and turns are mirrored with the other sign.
  PartJob twin = job;
  for (auto& instant : twin.load_sets.front().history.instants) {
    for (auto& wrench : instant.wrenches) wrench.moment *= -1.0;
    for (auto& load : instant.surface_loads) load.resultant.moment *= -1.0;
    instant.rigid.alpha *= -1.0;
    instant.rigid.omega *= -1.0;
  }
  const Eigen::MatrixXd in_mirror =
      components(seen_from(twin, mirrored, Vector3d::Zero()));
  ASSERT_EQ(in_mirror.rows(), here.rows());
  EXPECT_LT((in_mirror.cwiseAbs() - here.cwiseAbs()).lpNorm<Eigen::Infinity>(),
            1e-9);
}

// What stands still in the same component hides nothing either.
TEST(LoadPace, ChangesCountBesideWhatStandsStill) {
  for (const double preload : {0.0, 1e3}) {
    PartJob job = bar(transit());
    auto& instants = job.load_sets[0].history.instants;
    const double step = 1e-9 * transit();
    instants = {pulled(0.0, preload), pulled(5.0 * transit(), preload),
                pulled(5.0 * transit() + step, preload + 1.0),
                pulled(10.0 * transit(), preload + 1.0)};
    const auto components = load_components(job, job.load_sets.front());
    EXPECT_FALSE(is_slow(job, job.load_sets.front(), components));
    EXPECT_NEAR(load_spectrum(job, components, transit()).amplification, 2.0,
                0.02);
  }
}

// A block on a neck vibrates far slower than a bar of its size: loads that are
// slow beside the bar are not beside the block.
TEST(LoadPace, ANeckMakesAPartSlow) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  job.load_sets[0].fixed = {{"x0", {true, true, true}}};
  job.mesh = support::structured_mesh<3>(
      {20, 2, 2}, 1, [](const Vector3d& x) -> Vector3d {
        const double height =
            0.06 + 0.94 / (1.0 + std::exp(-(x.x() - 0.5) / 0.04));
        return kSize.cwiseProduct(
            Vector3d(x.x(), height * (x.y() - 0.5), x.z() - 0.5));
      });
  job.mass = mesh::mass_properties(job.mesh, kCork.density);
  auto& instants = job.load_sets[0].history.instants;
  instants.clear();
  const double rise = longest_period(job, job.load_sets.front());
  for (int i = 0; i <= 40; ++i) {  // a step across, in ten longest periods
    const double s = std::min(1.0, i / 20.0);
    instants.push_back(pulled(0.5 * rise * i, 0.0));
    instants.back().surface_loads.clear();
    instants.back().rigid.acceleration.y() = 10.0 * s * s * (3.0 - 2.0 * s);
  }
  const PartResult result = check_part(job).result;
  ASSERT_TRUE(result.first_period.has_value());
  EXPECT_GT(*result.first_period, rise);
}

// A held part that is shaken has no force on its surface but its supports'.
TEST(LoadPace, InertiaExcitesToo) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  job.load_sets[0].fixed = {{"x0", {true, true, true}}};
  auto& instants = job.load_sets[0].history.instants;
  const double step = 1e-9 * transit();
  instants.clear();
  for (const auto& [time, shake] : {std::pair{-transit(), 0.0},
                                    {-step, 0.0},
                                    {0.0, 1e5},
                                    {9.0 * transit(), 1e5}}) {
    instants.push_back(pulled(time, 0.0));
    instants.back().surface_loads.clear();
    instants.back().rigid.acceleration.x() = shake;
  }
  EXPECT_FALSE(is_slow(job, job.load_sets.front(),
                       load_components(job, job.load_sets.front())));
  const PartResult result = check_part(job).result;
  EXPECT_NEAR(result.peak.value, kCork.density * 1e5 * kSize.x(),
              0.01 * result.peak.value);
  EXPECT_NEAR(result.vibration.ratio.value(), 2.0, 0.06);
}

// A small force across a part may stress it more than a large one along it.
TEST(LoadPace, SmallComponentsCountToo) {
  PartJob job = bar(transit());
  auto& instants = job.load_sets[0].history.instants;
  const double step = 1e-9 * transit();
  instants = {pulled(0.0, 1.0), pulled(5.0 * transit(), 1.0),
              pulled(5.0 * transit() + step, 1.0),
              pulled(10.0 * transit(), 1.0)};
  EXPECT_TRUE(is_slow(job, job.load_sets.front(),
                      load_components(job, job.load_sets.front())));
  const auto across = [&](double share) {
    for (const std::size_t i : {2U, 3U}) {
      for (auto& load : instants[i].surface_loads) {
        load.resultant.force.y() = share * load.resultant.force.x();
      }
    }
  };
  across(0.02);
  const auto components = load_components(job, job.load_sets.front());
  EXPECT_FALSE(is_slow(job, job.load_sets.front(), components));
  EXPECT_NEAR(load_spectrum(job, components, transit()).amplification, 2.0,
              0.02);
  // What stands still hides nothing but round-off.
  across(0.5e-3);
  EXPECT_FALSE(is_slow(job, job.load_sets.front(),
                       load_components(job, job.load_sets.front())));
  across(1e-5);
  EXPECT_FALSE(is_slow(job, job.load_sets.front(),
                       load_components(job, job.load_sets.front())));
  across(1e-10);
  EXPECT_TRUE(is_slow(job, job.load_sets.front(),
                      load_components(job, job.load_sets.front())));
}

}  // namespace
}  // namespace clevis::assessment
