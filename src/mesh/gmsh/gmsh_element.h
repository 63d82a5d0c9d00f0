#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace clevis::mesh {

enum class ElementFamily {
  kPoint,
  kLine,
  kTriangle,
  kQuad,
  kTetrahedron,
  kHexahedron,
  kOther
};

/// An element type of the .msh format.
struct ElementType {
  int id{};
  std::string_view name;
  ElementFamily family{};
  int dim{}, order{}, nodes{};
  bool serendipity{};
};

/// The type with gmsh's number `id`; nullptr if there is none.
const ElementType* find_element_type(int id);

/// Corners of an element: its first nodes.
int corner_count(ElementFamily family);

/// Lexicographic index i + (n+1) (j + (n+1) k) of each node of gmsh's
/// complete hexahedron of order n: corners, edges, faces, interior, the last
/// two recursively. The inverse of what a reader needs is `out[index[a]] =
/// in[a]`.
std::vector<int> hexahedron_node_order(int order);

/// The same of gmsh's complete quadrangle: i + (n+1) j.
std::vector<int> quadrangle_node_order(int order);

/// Position in simplex_lattice<3> of each node of gmsh's tetrahedron of order
/// 1 or 2: corners, then the middles of the edges 01 12 20 30 23 13 (VTK has
/// the last two the other way round).
std::vector<int> tetrahedron_node_order(int order);

/// (27 × 20) values [1] of the serendipity functions of gmsh's 20-node
/// hexahedron at the lexicographic nodes of the complete one.
Eigen::MatrixXd serendipity_to_complete();

}  // namespace clevis::mesh
