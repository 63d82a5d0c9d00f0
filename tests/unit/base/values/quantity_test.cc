#include "base/values/quantity.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis {
namespace {

using enum Dimension;

double parsed(std::string_view text, Dimension dimension) {
  return parse_quantity(text, dimension, "x.toml:1:1");
}

/// Code of the refusal, or "accepted".
std::string refusal(std::string_view text, Dimension dimension) {
  try {
    parsed(text, dimension);
  } catch (const Error& error) {
    EXPECT_EQ(error.place(), "x.toml:1:1");
    EXPECT_NE(error.remedy().find(accepted_units(dimension)),
              std::string::npos);
    return error.code();
  }
  return "accepted";
}

struct Sample {
  const char* text;
  Dimension dimension;
  double si;
};

TEST(Quantity, ConvertsToSi) {
  // Round-off of one product and of the unit's own factor.
  constexpr double kRoundOff = 4e-16;
  const Sample samples[] = {
      {"140 mm", kLength, 0.14},
      {"140mm", kLength, 0.14},
      {"  -1.5e1 cm ", kLength, -0.15},
      {"+2 in", kLength, 0.0508},
      {"3 \xC2\xB5m", kLength, 3e-6},
      {"0 m", kLength, 0.0},
      {"72 deg", kAngle, 0.4 * std::numbers::pi},
      {"90 degree", kAngle, 0.5 * std::numbers::pi},
      {"1 rad", kAngle, 1.0},
      {"2 min", kTime, 120.0},
      {"2 t", kMass, 2000.0},
      {"2 kg m^2", kMassMoment, 2.0},
      {"2 g mm^2", kMassMoment, 2e-9},
      {"1 kN", kForce, 1000.0},
      {"1 lbf", kForce, 4.4482216152605},
      {"3 N m", kTorque, 3.0},
      {"3 N\xC2\xB7m", kTorque, 3.0},
      {"3 N*mm", kTorque, 3e-3},
      {"3 J", kTorque, 3.0},
      {"210 GPa", kStress, 210e9},
      {"355 N/mm^2", kStress, 355e6},
      {"1 bar", kStress, 1e5},
      {"7.85 g/cm^3", kDensity, 7850.0},
      {"7850 kg m-3", kDensity, 7850.0},
      {"36 km/h", kVelocity, 10.0},
      {"-9.81 m/s^2", kAcceleration, -9.81},
      {"25 Hz", kFrequency, 25.0},
      {"60 1/min", kFrequency, 1.0},
      {"1500 rpm", kAngularVelocity, 50.0 * std::numbers::pi},
      {"180 deg/s", kAngularVelocity, std::numbers::pi},
      {"2 rad/s^2", kAngularAcceleration, 2.0},
      {"1 %", kRatio, 0.01},
      {"1%", kRatio, 0.01},
      {"0.5 1", kRatio, 0.5},
  };
  for (const Sample& sample : samples) {
    EXPECT_NEAR(parsed(sample.text, sample.dimension), sample.si,
                kRoundOff * std::abs(sample.si))
        << sample.text;
  }
}

TEST(Quantity, EveryListedUnitIsAccepted) {
  for (int i = 0; i <= static_cast<int>(kRatio); ++i) {
    const auto dimension = static_cast<Dimension>(i);
    std::string units(accepted_units(dimension));
    for (std::size_t start = 0; start < units.size();) {
      const std::size_t end = std::min(units.find(", ", start), units.size());
      const std::string text = "2 " + units.substr(start, end - start);
      EXPECT_GT(parsed(text, dimension), 0.0) << text;
      start = end + 2;
    }
  }
}

TEST(Quantity, RefusesMissingUnknownAndForeignUnits) {
  EXPECT_EQ(refusal("140", kLength), "S004");
  EXPECT_EQ(refusal("", kLength), "S004");
  EXPECT_EQ(refusal("mm", kLength), "S004");
  EXPECT_EQ(refusal("140 furz", kLength), "S004");
  EXPECT_EQ(refusal("140 N", kLength), "S004");
  EXPECT_EQ(refusal("1,5 mm", kLength), "S004");
  EXPECT_EQ(refusal("140 mm^2", kLength), "S004");
  EXPECT_EQ(refusal("140 %", kLength), "S004");
  EXPECT_EQ(refusal("1 m", kRatio), "S004");
  EXPECT_EQ(refusal("0.5", kRatio), "S004");  // 50 % or 0.5 %?
}

TEST(Quantity, TellsADecimalComma) {
  try {
    parse_quantity("8,5 mm", kLength, "here");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.problem().find("has a comma"), std::string::npos)
        << error.problem();
  }
}

// Texts that udunits2 alone would take, and silently change the value.
TEST(Quantity, RefusesWhatUdunitsWouldReinterpret) {
  EXPECT_EQ(refusal("140 2 mm", kLength), "S004");    // 280 mm
  EXPECT_EQ(refusal("140 mm @ 5", kLength), "S004");  // offset
  EXPECT_EQ(refusal("5 mm from 3", kLength), "S004");
  EXPECT_EQ(refusal("5 Hz", kTime), "S004");              // reciprocal
  EXPECT_EQ(refusal("25 Hz", kAngularVelocity), "S004");  // 2π lost
  EXPECT_EQ(refusal("25 rpm", kFrequency), "S004");
  EXPECT_EQ(refusal("1 rad", kRatio), "S004");
  EXPECT_EQ(refusal("3 lg(re 1 m)", kLength), "S004");
  EXPECT_EQ(refusal(std::string_view("140 mm\0 junk", 12), kLength), "S004");
  EXPECT_EQ(refusal("1 " + std::string(100000, 'm'), kLength), "S004");
  EXPECT_EQ(refusal("1 m\xff", kLength), "S004");
}

TEST(Quantity, RefusesNonFiniteNumbers) {
  EXPECT_EQ(refusal("nan mm", kLength), "S006");
  EXPECT_EQ(refusal("inf N", kForce), "S006");
  EXPECT_EQ(refusal("-inf N", kForce), "S006");
  EXPECT_EQ(refusal("1e999 N", kForce), "S006");
  EXPECT_EQ(refusal("1e308 GPa", kStress), "S006");
}

}  // namespace
}  // namespace clevis
