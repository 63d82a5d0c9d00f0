#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/cells/part_mesh.h"
#include "part/bore.h"

namespace clevis::mesh {

/// A cylinder that flat facets of a mesh stand for, though no group says so.
struct FacetedRound {
  part::Bore cylinder;
  std::vector<std::size_t> faces;  ///< of PartMesh::boundary
};

/// Cylinders behind flat faces without a round group, from the rims where they
/// end: five and more vertices of a sharp rim, one after the other, on one
/// circle (1e-5 of its radius) that turn the same way by at most 22.7° each
/// (a circle of 16), 44° together, or that go all round a hole by at most 51.5°
/// each (7); and all faces beside such a rim,
/// and beside those, whose corners lie on that cylinder. Nothing for curved
/// cells: their faces are what the file says.
std::vector<FacetedRound> faceted_rounds(const PartMesh<3>& mesh);

/// "16 facets round (0, 0, 4) mm lie on a cylinder of radius 10 mm and are
/// taken for it".
std::string text(const FacetedRound& round);

}  // namespace clevis::mesh
