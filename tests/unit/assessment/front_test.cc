// Bands of blows whose waves the mesh does not carry. Source: docs/theory.md,
// "Impact by finite elements".

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/impact/impact_check.h"
#include "assessment/impact/wave_front_refinement.h"
#include "assessment/judge/sampled_peak.h"
#include "support/plate_job.h"
#include "support/rod_peak.h"
#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kLength = 0.1, kSide = 0.01;
constexpr int kSamples = 400;
const std::vector<double> kAllRises = {0.0, 0.003, 0.03, 0.1, 0.3, 1.0, 3.0};

/// A curve with a hill of that height about each time.
VectorXd hills(std::initializer_list<std::pair<double, double>> tops) {
  VectorXd curve = VectorXd::Zero(kSamples + 1);
  for (Index i = 0; i <= kSamples; ++i) {
    for (const auto& [at, height] : tops) {
      const double x = (static_cast<double>(i) / kSamples - at) / 0.05;
      curve[i] = std::max(curve[i], height * std::exp(-x * x));
    }
  }
  return curve;
}

TEST(WaveFrontError, BoundsWhatFallsWithAPowerOfTheFront) {
  for (const double power : {0.5, 0.7, 1.0}) {
    const auto peak = [&](double front) {
      return 100.0 - 20.0 * std::pow(front, power);
    };
    const double one = peak(0.25);
    const auto error =
        wave_front_error(hills({{0.5, one}}), hills({{0.5, peak(0.5)}}),
                         hills({{0.5, peak(1.0)}}), 20, slowest_fall(0.0));
    EXPECT_NEAR(one * (1.0 + error.above), 100.0, 1e-9) << power;
    EXPECT_NEAR(error.below, 0.1 * error.above, 1e-12);
  }
}

TEST(WaveFrontError, SeesThePeakThatStillHidesBehindAnother) {
  const auto peaks = [](double front) {
    return hills({{0.2, 80.0}, {0.7, 92.0 - 30.0 * std::sqrt(front)}});
  };
  const auto error = wave_front_error(peaks(0.25), peaks(0.5), peaks(1.0), 20,
                                      slowest_fall(0.0));
  EXPECT_NEAR(80.0 * (1.0 + error.above), 92.0, 1e-9);
}

TEST(WaveFrontError, WhatOvershootsIsLeftBelow) {
  const auto error =
      wave_front_error(hills({{0.5, 101.0}}), hills({{0.5, 102.0}}),
                       hills({{0.5, 104.0}}), 20, slowest_fall(0.0));
  EXPECT_NEAR(101.0 * (1.0 - error.below), 100.0, 1e-9);
}

TEST(SampledPeak, SmoothTopsAndCuspsBetweenSamples) {
  for (double shift = 0.0; shift < 1.0; shift += 0.05) {
    VectorXd smooth(41), cusp(41);
    for (Index i = 0; i <= 40; ++i) {
      const double x = static_cast<double>(i) - 20.0 - shift;
      smooth[i] = std::cos(0.1 * x);
      cusp[i] = 1.0 + (x < 0.0 ? 0.02 * x : -0.03 * x);
    }
    const double smooth_left = 1.0 - smooth.maxCoeff();
    EXPECT_GE(rise_between_samples(smooth) + 3e-6, smooth_left) << shift;
    EXPECT_LT(rise_between_samples(smooth), 2e-3) << shift;
    EXPECT_GE(rise_between_samples(cusp) + 1e-12, 1.0 - cusp.maxCoeff())
        << shift;
    EXPECT_LT(rise_between_samples(cusp), 0.013) << shift;
  }
}

/// A bar along x without Poisson's ratio, held at x0: a rod, of cells that grow
/// along it by a power.
PartJob rod(int cells, double power) {
  PartJob job;
  job.part.name = "rod";
  job.part.material = {"no Poisson", 200e9, 0.0, 8000.0, 355e6};
  job.mesh = support::structured_mesh<3>(
      {cells, 1, 1}, 1, [=](const Vector3d& x) -> Vector3d {
        return {kLength * std::pow(x[0], power), kSide * x[1], kSide * x[2]};
      });
  job.mass = mesh::mass_properties(job.mesh, job.part.material.density);
  for (const auto& group : job.mesh.groups) {
    const auto flat = support::flat_face(job.mesh, group.name);
    loads::GroupGeometry geometry;
    geometry.name = group.name;
    geometry.area = flat.area;
    geometry.centroid = flat.centroid;
    job.groups.push_back(geometry);
  }
  return job;
}

// A hundredth of the energy lost is a tenth of the stress at rest; half of it
// where the contact rises in four fronts.
TEST(LostEnergy, StressesAsItWouldAtRest) {
  StruckRun<3> run;
  run.factor = 1.25;
  run.response.solution.run.energy_error = 0.01;
  run.response.solution.damping_time = 1e-6;
  run.response.solution.rise_time = 2e-6;
  EXPECT_NEAR(stress_of_lost_energy(run), 0.1 / 1.25, 1e-12);
  run.response.solution.rise_time = 4e-6;
  EXPECT_NEAR(stress_of_lost_energy(run), 0.05 / 1.25, 1e-12);
}

/// Mass ratios and rises Z/k over the wave's time through the rod; 0: ideal.
/// d'Alembert's peak must be in the band on meshes that carry the front and on
/// those that do not. With CLEVIS_ALL_BLOWS in the environment 105 of them.
TEST(BlowOnARod, BandHoldsDAlembertsPeak) {
  const double unit = std::sqrt(200e9 * 8000.0);  // at 1 m/s
  const double wave = kLength / std::sqrt(200e9 / 8000.0);
  struct Case {
    int cells;
    double power;
    std::vector<double> ratios, rises;
  };
  const std::vector<Case> cases =
      std::getenv("CLEVIS_ALL_BLOWS") != nullptr
          ? std::vector<Case>{{6, 1.0, {0.5, 1, 2, 3, 4}, kAllRises},
                              {8, 1.6, {0.5, 1, 2, 3, 4}, kAllRises},
                              {24, 1.0, {0.5, 1, 2, 3, 4}, kAllRises}}
          : std::vector<Case>{{6, 1.0, {1, 2, 4}, {0.0, 0.003, 0.03, 0.3, 3}},
                              {8, 1.6, {0.5, 2}, {0.0, 0.1, 1}},
                              {24, 1.0, {1}, {0.03}}};
  for (const auto& [cells, power, ratios, rises] : cases) {
    PartJob job = rod(cells, power);
    for (const double ratio : ratios) {
      for (const double rise : rises) {
        ImpactJob impact;
        impact.strike.name = "blow";
        impact.strike.group = "x1";
        impact.strike.direction = -Vector3d::UnitX();
        impact.strike.mass = ratio * job.mass.mass;
        impact.strike.speed = 1.0;
        const double impedance = unit * kSide * kSide;
        impact.strike.contact.stiffness =
            rise > 0.0 ? impedance / (rise * wave)
                       : std::numeric_limits<double>::infinity();
        impact.fixed = {{"x0", {true, true, true}}};
        job.impacts = {impact};
        const auto found = check_blows(job).impacts.front();
        const double exact =
            unit * support::rod_peak(ratio, rise > 0.0 ? rise : 3e-4, 9.0);
        const double low = found.band_low / exact - 1.0;
        const double high = found.band_high / exact - 1.0;
        std::printf(
            "%2d cells^%.1f, ratio %.1f, rise %.3f: %6.2f MPa %+.2f %%,"
            " band %+.2f %+.2f %%%s\n",
            cells, power, ratio, rise, exact / 1e6,
            100.0 * (found.stress / exact - 1.0), 100.0 * low, 100.0 * high,
            found.refinement.settles ? "" : ", unsettled");
        constexpr double kReference = 1e-3;
        EXPECT_LT(low, kReference) << cells << " " << ratio << " " << rise;
        EXPECT_GT(high, -kReference) << cells << " " << ratio << " " << rise;
      }
    }
  }
}

}  // namespace
}  // namespace clevis::assessment
