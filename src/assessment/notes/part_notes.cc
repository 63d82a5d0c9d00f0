#include "assessment/notes/part_notes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "loads/history/balance.h"
#include "mesh/cells/topology.h"

namespace clevis::assessment {
namespace {

using Notes = std::vector<std::string>;

void note_size(double size, Notes& notes) {
  constexpr double kSmall = 1e-3, kLarge = 3.0;  // [m]
  if (kSmall <= size && size <= kLarge) return;
  notes.push_back(fmt::format(
      "the part is {:.3g} m large: see that the unit of its lengths is right",
      size));
}

constexpr double kStrong = 2.5e9;  // but for wires and fibres [Pa]

/// Stiff foams yield at 1 MPa.
void note_yield_strength(const part::Material& material, Notes& notes) {
  constexpr double kWeak = 1e6, kMega = 1e6;  // [Pa]
  if (kWeak <= material.yield_strength && material.yield_strength <= kStrong) {
    return;
  }
  notes.push_back(
      fmt::format("the yield strength of {} is {:.4g} MPa, outside 1 MPa to "
                  "2.5 GPa: see that its unit is right",
                  material.name, material.yield_strength / kMega));
}

/// Such a limit fails hardly any part: beams of cranes have a 250th to a 500th
/// of their length.
void note_deflection_limit(const part::Limits& limits, double size,
                           Notes& notes) {
  constexpr double kLarge = 0.05, kMilli = 1e-3;
  if (!limits.deflection || *limits.deflection <= kLarge * size) return;
  notes.push_back(
      fmt::format("the limit of deflection is {:.4g} mm, more than a 20th of "
                  "the part's size "
                  "({:.4g} mm): see that its unit is right",
                  *limits.deflection / kMilli, size / kMilli));
}

/// Parts that stand alone, whose lengths no joint's place confirms.
bool stands_alone(const part::PartDefinition& part) {
  return !part.cases.empty() || !part.series.empty();
}

/// What the numbers of the mesh and of the density were taken for.
void note_extent(const PartJob& job, Notes& notes) {
  constexpr double kMilli = 1e-3;
  if (!stands_alone(job.part)) return;
  const Eigen::Vector3d sides = job.sides() / kMilli;
  notes.push_back(fmt::format("size {:.4g} x {:.4g} x {:.4g} mm, {:.4g} kg",
                              sides[2], sides[1], sides[0], job.mass.mass));
}

/// A sheet that thin holds no pin.
void note_thickness(const PartJob& job, Notes& notes) {
  constexpr double kThin = 1e-3, kMilli = 1e-3;
  const Eigen::Vector3d sides = job.sides();
  if (sides[0] >= kThin * sides[2]) return;
  notes.push_back(fmt::format(
      "the part is {:.4g} mm thick, less than a thousandth of its {:.4g} mm: "
      "see that the unit of its thickness is right",
      sides[0] / kMilli, sides[2] / kMilli));
}

bool is_heavy_as_steel(const part::Material& material) {
  constexpr double kLightest = 7700.0, kHeaviest = 8000.0;  // [kg/m³]
  return kLightest <= material.density && material.density <= kHeaviest;
}

/// Of a plate from its mid-plane: its number is read, not measured.
void note_thick_plate(const PartJob& job, Notes& notes) {
  constexpr double kThick = 2.0, kMilli = 1e-3;
  const double width = job.sides()[0];
  const double thickness = job.part.thickness.value_or(0.0);
  if (thickness <= kThick * width) return;
  notes.push_back(fmt::format(
      "its thickness of {:.4g} mm is {:.3g} times its width of {:.4g} mm: see "
      "that its unit is right",
      thickness / kMilli, thickness / width, width / kMilli));
}

/// Of one kind of material all three are known but for a factor of some tens.
void note_stiffness(const part::Material& material, Notes& notes) {
  constexpr double kFastest = 20e3;     // sound in diamond: 18e3 [m/s]
  constexpr double kHeavy = 2000.0;     // rubber and foams are lighter [kg/m³]
  constexpr double kHeaviest = 23e3;    // osmium: 22.6e3 [kg/m³]
  constexpr double kLight = 1200.0;     // magnesium 1740, carbon fibre 1550
  constexpr double kMetallic = 7000.0;  // [kg/m³]
  constexpr double kSoft = 0.4e9;  // PTFE, as heavy as that, has 0.5e9 [Pa]
  constexpr double kStiff = 30e9;  // wood along its grain: 20e9 [Pa]
  constexpr double kLeastOfSteel = 130e9, kMostOfSteel = 240e9;  // Invar: 140e9
  constexpr double kStretch = 0.5;           // plastics yield at 0.05 [1]
  constexpr double kStretchOfMetal = 0.015;  // wires of steel: 0.012 [1]
  constexpr double kGiga = 1e9, kMega = 1e6;
  const double modulus = material.youngs_modulus;
  const double sound = std::sqrt(modulus / material.density);
  const double stretch = material.yield_strength / modulus;
  if (sound > kFastest || material.density > kHeaviest ||
      (material.density < kLight && modulus > kStiff) ||
      (material.density > kHeavy && modulus < kSoft)) {
    notes.push_back(fmt::format(
        "{} has {:.4g} GPa at {:.4g} kg/m^3, as no material: see that the "
        "units of its Young's modulus and density are right",
        material.name, modulus / kGiga, material.density));
    return;
  }
  if (is_heavy_as_steel(material) &&
      (modulus < kLeastOfSteel || modulus > kMostOfSteel)) {
    notes.push_back(
        fmt::format("{} is as heavy as steel ({:.4g} kg/m^3), which has 190 to "
                    "215 GPa, and has {:.4g} GPa: see that both are right",
                    material.name, material.density, modulus / kGiga));
    return;
  }
  const double most = material.density > kMetallic ? kStretchOfMetal : kStretch;
  if (modulus >= kSoft && stretch > most &&
      material.yield_strength <= kStrong) {
    notes.push_back(fmt::format(
        "{} yields at {:.4g} MPa, a strain of {:.2g} %: see that the units of "
        "its yield strength and Young's modulus are right",
        material.name, material.yield_strength / kMega, 100.0 * stretch));
  }
}

/// Rubber has 0.1, links on pins 0.03.
void note_damping(const part::PartDefinition& part, Notes& notes) {
  constexpr double kLargest = 0.3;
  if (part.damping <= kLargest) return;
  notes.push_back(fmt::format(
      "its damping is {:.3g} of the critical, links have 0.005 to 0.03: see "
      "that it is the ratio, not percent",
      part.damping));
}

/// Cork has zero, beryllium 0.03, concrete 0.1; foams are below zero, if made
/// so.
void note_poissons_ratio(const part::Material& material, Notes& notes) {
  constexpr double kLeast = 0.03, kLeastOfSteel = 0.2;
  const double ratio = material.poissons_ratio;
  if (ratio == 0.0) return;
  if (is_heavy_as_steel(material) && ratio < kLeastOfSteel) {
    notes.push_back(fmt::format(
        "Poisson's ratio of {} is {:.4g}, and steel, as heavy as that, has "
        "0.27 to 0.31: see that it is right",
        material.name, ratio));
    return;
  }
  if (ratio >= kLeast) return;
  notes.push_back(fmt::format(
      "Poisson's ratio of {} is {:.4g}, as of hardly any material: see that it "
      "is right",
      material.name, ratio));
}

/// @param acceleration  minus gravity [m/s²].
void note_acceleration(const std::string& load, double acceleration,
                       Notes& notes) {
  if (acceleration <= loads::kHardAcceleration) return;
  notes.push_back(fmt::format(
      "{}: its acceleration minus gravity is {:.4g} m/s^2, {:.4g} times the "
      "earth's gravity: see that its unit is right",
      load, acceleration, acceleration / loads::kEarthGravity));
}

/// As of one in N where the other is in kN.
void note_small_cases(const part::PartDefinition& part, Notes& notes) {
  constexpr double kSmall = 1.0 / 300.0;
  const auto largest_force = [](const part::LoadCaseDefinition& load) {
    double largest = 0.0;
    for (const auto& [group, force] : load.pins) {
      largest = std::max(largest, force.norm());
    }
    return largest;
  };
  const part::LoadCaseDefinition* largest = nullptr;
  for (const auto& load : part.cases) {
    if (!largest || largest_force(load) > largest_force(*largest)) {
      largest = &load;
    }
  }
  for (const auto& load : part.cases) {
    const double force = largest_force(load);
    if (force == 0.0 || force >= kSmall * largest_force(*largest)) continue;
    notes.push_back(fmt::format(
        "the largest force of case {} is {:.4g} N, that of case {} {:.4g} N: "
        "see that the units of both are right",
        load.name, force, largest->name, largest_force(*largest)));
  }
}

void note_series(const part::LoadSeries& series, Notes& notes) {
  double largest = 0.0;
  for (const part::SeriesInstant& instant : series.instants) {
    largest = std::max(largest, instant.acceleration.norm());
  }
  note_acceleration("history " + series.name, largest, notes);
}

}  // namespace

std::vector<std::string> part_notes(const PartJob& job) {
  Notes notes;
  const double size = mesh::size_of(job.mesh);
  note_extent(job, notes);
  note_size(size, notes);
  note_thickness(job, notes);
  note_thick_plate(job, notes);
  note_yield_strength(job.part.material, notes);
  note_stiffness(job.part.material, notes);
  note_poissons_ratio(job.part.material, notes);
  note_damping(job.part, notes);
  note_deflection_limit(job.part.limits, size, notes);
  for (const auto& load_case : job.part.cases) {
    note_acceleration("case " + load_case.name, load_case.acceleration.norm(),
                      notes);
  }
  note_small_cases(job.part, notes);
  for (const auto& series : job.part.series) note_series(series, notes);
  for (const std::string& group : job.mesh.empty_groups) {
    notes.push_back(fmt::format(
        "the physical group {} of the mesh holds no surface of the part",
        group));
  }
  return notes;
}

std::vector<std::string> strength_notes(double safety_factor) {
  constexpr double kIdle = 100.0, kHopeless = 0.01;
  if (safety_factor > kIdle) {
    return {fmt::format(
        "its loads use less than a hundredth of its strength (safety factor "
        "{:.4g}): see that the units of loads and lengths are right",
        safety_factor)};
  }
  if (0.0 < safety_factor && safety_factor < kHopeless) {
    return {fmt::format(
        "its loads would need {:.0f} times its strength: see that the units of "
        "loads, lengths and speeds are right",
        1.0 / safety_factor)};
  }
  return {};
}

}  // namespace clevis::assessment
