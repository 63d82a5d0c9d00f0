#include "assessment/notes/part_notes.h"

#include <fmt/format.h>

#include "mesh/cells/topology.h"

namespace clevis::assessment {

std::vector<std::string> part_notes(const PartJob& job) {
  constexpr double kSmall = 1e-3, kLarge = 3.0;  // m
  std::vector<std::string> notes;
  const double size = mesh::size_of(job.mesh);
  if (size < kSmall || size > kLarge) {
    notes.push_back(fmt::format(
        "the part is {:.3g} m large: see that the unit of its lengths is right",
        size));
  }
  for (const std::string& group : job.mesh.empty_groups) {
    notes.push_back(fmt::format(
        "the physical group {} of the mesh holds no surface of the part",
        group));
  }
  return notes;
}

}  // namespace clevis::assessment
