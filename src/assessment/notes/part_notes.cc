#include "assessment/notes/part_notes.h"

#include <fmt/format.h>

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

/// Stiff foams yield at 1 MPa, the best wires at 4 GPa.
void note_yield_strength(const part::Material& material, Notes& notes) {
  constexpr double kWeak = 1e6, kStrong = 5e9, kMega = 1e6;  // [Pa]
  if (kWeak <= material.yield_strength && material.yield_strength <= kStrong) {
    return;
  }
  notes.push_back(
      fmt::format("the yield strength of {} is {:.4g} MPa, outside 1 MPa to 5 "
                  "GPa: see that its unit is right",
                  material.name, material.yield_strength / kMega));
}

/// Such a limit fails no part.
void note_deflection_limit(const part::Limits& limits, double size,
                           Notes& notes) {
  constexpr double kLarge = 0.5, kMilli = 1e-3;
  if (!limits.deflection || *limits.deflection <= kLarge * size) return;
  notes.push_back(fmt::format(
      "the limit of deflection is {:.4g} mm, more than half of the part's size "
      "({:.4g} mm): see that its unit is right",
      *limits.deflection / kMilli, size / kMilli));
}

/// As of gravity in mm/s² whose unit was typed as m/s²; pistons of engines
/// reach it, too.
void note_acceleration(const part::LoadCaseDefinition& load_case,
                       Notes& notes) {
  constexpr double kEarth = 9.81;              // [m/s²]
  constexpr double kLargest = 500.0 * kEarth;  // [m/s²]
  const double acceleration = load_case.acceleration.norm();
  if (acceleration <= kLargest) return;
  notes.push_back(fmt::format(
      "case {}: its acceleration minus gravity is {:.4g} m/s^2, {:.4g} times "
      "the earth's gravity: see that its unit is right",
      load_case.name, acceleration, acceleration / kEarth));
}

}  // namespace

std::vector<std::string> part_notes(const PartJob& job) {
  Notes notes;
  const double size = mesh::size_of(job.mesh);
  note_size(size, notes);
  note_yield_strength(job.part.material, notes);
  note_deflection_limit(job.part.limits, size, notes);
  for (const auto& load_case : job.part.cases) {
    note_acceleration(load_case, notes);
  }
  for (const std::string& group : job.mesh.empty_groups) {
    notes.push_back(fmt::format(
        "the physical group {} of the mesh holds no surface of the part",
        group));
  }
  return notes;
}

}  // namespace clevis::assessment
