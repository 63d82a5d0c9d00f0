#include "elasticity/fe_space/simplex_numbering.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "mesh/basis/simplex_basis.h"

namespace clevis::elasticity {
namespace {

/// Vertices with their share of a node, ascending; unused places are last.
template <int dim>
using NodeKey = std::array<std::pair<unsigned, int>, dim + 1>;

template <int dim>
NodeKey<dim> node_key(const std::vector<unsigned>& cell,
                      const mesh::SimplexIndex<dim>& index) {
  constexpr std::pair<unsigned, int> kUnused = {~0U, 0};
  NodeKey<dim> key;
  for (std::size_t v = 0; v < key.size(); ++v) {
    key[v] = index[v] > 0 ? std::pair(cell[v], index[v]) : kUnused;
  }
  std::ranges::sort(key);
  return key;
}

}  // namespace

template <int dim>
SimplexNumbering number_simplices(const mesh::PartMesh<dim>& mesh, int degree) {
  const auto lattice = mesh::simplex_lattice<dim>(degree);
  SimplexNumbering numbering;
  numbering.vertex_nodes.assign(mesh.vertices.size(), -1);
  numbering.cell_nodes.resize(mesh.cells.size());
  std::map<NodeKey<dim>, int> number;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const auto& index : lattice) {
      const auto [at, added] = number.try_emplace(
          node_key<dim>(mesh.cells[c], index), numbering.nodes);
      numbering.nodes += added ? 1 : 0;
      numbering.cell_nodes[c].push_back(at->second);
      const auto vertex = std::ranges::find(index, degree);
      if (vertex != index.end()) {
        const auto v = static_cast<std::size_t>(vertex - index.begin());
        numbering.vertex_nodes[mesh.cells[c][v]] = at->second;
      }
    }
  }
  return numbering;
}

template SimplexNumbering number_simplices<2>(const mesh::PartMesh<2>&, int);
template SimplexNumbering number_simplices<3>(const mesh::PartMesh<3>&, int);

}  // namespace clevis::elasticity
