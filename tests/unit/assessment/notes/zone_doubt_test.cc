#include "assessment/notes/zone_doubt.h"

#include <gtest/gtest.h>

#include "unit/assessment/pulled_bar.h"

namespace clevis::assessment {
namespace {

constexpr double kPeak = 100e6;    // [Pa]
constexpr double kForce = 1000.0;  // [N]
const double kCell = kSize.x() / 20.0;

/// The bar's face y = −10 mm as a wall, pressed in its middle over a length.
PartJob pressed_bar(double length) {
  PartJob job = bar(0.0);
  loads::Seat seat;
  seat.name = "slide";
  seat.group = "y0";
  seat.p_LS = {0.5 * kSize.x(), -0.5 * kSize.y(), 0.0};
  seat.slide = loads::SlideWall{.along_L = Eigen::Vector3d::UnitX(),
                                .across_L = Eigen::Vector3d::UnitZ(),
                                .normal_L = Eigen::Vector3d::UnitY(),
                                .opposite = ""};
  loads::GroupGeometry wall;
  wall.name = "y0";
  wall.points.resize(3, 2);
  wall.points << 0.0, kSize.x(), 0.0, 0.0, -0.5 * kSize.z(), 0.5 * kSize.z();
  job.groups = {wall};
  loads::LoadHistory& history = job.load_sets.front().history;
  history.seats = {seat};
  loads::InstantLoad instant;
  instant.wrenches = {{.force = {0.0, kForce, 0.0}}};
  loads::ContactZone zone;
  zone.low[0] = -0.5 * length;
  zone.high[0] = 0.5 * length;
  instant.zones = {zone};
  history.instants = {instant};
  return job;
}

PartResult result_at(double x, double peak = kPeak) {
  PartResult result;
  result.peak.value = result.peak.band_low = result.peak.band_high = peak;
  result.peak.at = {x, -0.5 * kSize.y(), 0.0};
  result.peak.verdict = PeakVerdict::kConverged;
  return result;
}

double widened_by(const PartJob& job, PartResult result) {
  add_zone_doubt(job, result);
  EXPECT_EQ(result.notes.empty(), result.peak.band_high == result.peak.value);
  return result.peak.band_high - result.peak.value;
}

TEST(ZoneDoubt, OfZonesThatAreShorterThanTheirCells) {
  const double middle = 0.5 * kSize.x();
  EXPECT_EQ(widened_by(pressed_bar(0.6 * kCell), result_at(middle)), 0.0);
  const PartJob third = pressed_bar(kCell / 3.0);
  EXPECT_NEAR(widened_by(third, result_at(middle)), 0.1 * kPeak, 1e-9 * kPeak);
  // Of a peak elsewhere it says nothing.
  EXPECT_EQ(widened_by(third, result_at(middle - kCell)), 0.0);
}

TEST(ZoneDoubt, WhereThePressureIsNotSeen) {
  const double length = kCell / 30.0;
  const double pressure = kForce / (length * kSize.z());
  const PartJob job = pressed_bar(length);
  const double lost = 0.5 * pressure, seen = 0.6 * pressure;
  EXPECT_NEAR(widened_by(job, result_at(0.0, lost)), pressure - lost,
              1e-9 * pressure);
  EXPECT_EQ(widened_by(job, result_at(0.0, seen)), 0.0);
}

}  // namespace
}  // namespace clevis::assessment
