// Meshes of gmsh, with whatever a part reads from them.
#include <optional>

#include "base/messages/errors.h"
#include "fuzz/fuzz_target.h"
#include "mesh/reading/mesh_reader.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto file = clevis::testing::as_file(data, size, "part.msh");
    const bool is_flat = size % 2 == 1;
    clevis::mesh::read_mesh_with_notes(
        file, 1e-3,
        is_flat ? std::optional<double>(5e-3) : std::optional<double>());
  } catch (const clevis::Error&) {  // refused, as it should be
  }
  return 0;
}
