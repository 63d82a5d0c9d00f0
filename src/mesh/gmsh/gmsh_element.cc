#include "mesh/gmsh/gmsh_element.h"

#include <algorithm>
#include <array>

#include "mesh/basis/simplex_basis.h"

namespace clevis::mesh {

namespace {

using Index2 = std::array<int, 2>;
using Index3 = std::array<int, 3>;
using F = ElementFamily;

constexpr std::array kTypes = std::to_array<ElementType>({
    {1, "2-node line", F::kLine, 1, 1, 2},
    {2, "3-node triangle", F::kTriangle, 2, 1, 3},
    {3, "4-node quadrangle", F::kQuad, 2, 1, 4},
    {4, "4-node tetrahedron", F::kTetrahedron, 3, 1, 4},
    {5, "8-node hexahedron", F::kHexahedron, 3, 1, 8},
    {6, "6-node prism", F::kOther, 3, 1, 6},
    {7, "5-node pyramid", F::kOther, 3, 1, 5},
    {8, "3-node line", F::kLine, 1, 2, 3},
    {9, "6-node triangle", F::kTriangle, 2, 2, 6},
    {10, "9-node quadrangle", F::kQuad, 2, 2, 9},
    {11, "10-node tetrahedron", F::kTetrahedron, 3, 2, 10},
    {12, "27-node hexahedron", F::kHexahedron, 3, 2, 27},
    {13, "18-node prism", F::kOther, 3, 2, 18},
    {14, "14-node pyramid", F::kOther, 3, 2, 14},
    {15, "point", F::kPoint, 0, 0, 1},
    {16, "8-node quadrangle", F::kQuad, 2, 2, 8, true},
    {17, "20-node hexahedron", F::kHexahedron, 3, 2, 20, true},
    {18, "15-node prism", F::kOther, 3, 2, 15},
    {19, "13-node pyramid", F::kOther, 3, 2, 13},
    {20, "9-node triangle", F::kOther, 2, 3, 9},
    {21, "10-node triangle", F::kOther, 2, 3, 10},
    {22, "12-node triangle", F::kOther, 2, 4, 12},
    {23, "15-node triangle", F::kOther, 2, 4, 15},
    {24, "15-node triangle", F::kOther, 2, 5, 15},
    {25, "21-node triangle", F::kOther, 2, 5, 21},
    {26, "4-node line", F::kLine, 1, 3, 4},
    {27, "5-node line", F::kLine, 1, 4, 5},
    {28, "6-node line", F::kLine, 1, 5, 6},
    {29, "20-node tetrahedron", F::kOther, 3, 3, 20},
    {30, "35-node tetrahedron", F::kOther, 3, 4, 35},
    {31, "56-node tetrahedron", F::kOther, 3, 5, 56},
    {36, "16-node quadrangle", F::kQuad, 2, 3, 16},
    {37, "25-node quadrangle", F::kQuad, 2, 4, 25},
    {38, "36-node quadrangle", F::kOther, 2, 5, 36},
    {90, "40-node prism", F::kOther, 3, 3, 40},
    {91, "75-node prism", F::kOther, 3, 4, 75},
    {92, "64-node hexahedron", F::kHexahedron, 3, 3, 64},
    {93, "125-node hexahedron", F::kHexahedron, 3, 4, 125},
    {94, "216-node hexahedron", F::kOther, 3, 5, 216},
});

// gmsh's reference hexahedron: corners, edges and faces by corner.
constexpr std::array<Index3, 8> kCorners = {{{0, 0, 0},
                                             {1, 0, 0},
                                             {1, 1, 0},
                                             {0, 1, 0},
                                             {0, 0, 1},
                                             {1, 0, 1},
                                             {1, 1, 1},
                                             {0, 1, 1}}};
constexpr std::array<Index2, 12> kEdges = {{{0, 1},
                                            {0, 3},
                                            {0, 4},
                                            {1, 2},
                                            {1, 5},
                                            {2, 3},
                                            {2, 6},
                                            {3, 7},
                                            {4, 5},
                                            {4, 7},
                                            {5, 6},
                                            {6, 7}}};
// Origin, end of the first and end of the second direction of each face.
constexpr std::array<Index3, 6> kFaces = {
    {{0, 3, 1}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {2, 3, 6}, {4, 5, 7}}};

const Index3& corner(int i) {
  return kCorners[std::size_t(i)];
}

/// Point a·order + s (b − a) + t (c − a) of the reference lattice.
Index3 lattice(int order, const Index3& a, const Index3& b, int s,
               const Index3& c, int t) {
  Index3 p{};
  for (std::size_t d = 0; d < 3; ++d) {
    p[d] = order * a[d] + s * (b[d] - a[d]) + t * (c[d] - a[d]);
  }
  return p;
}

std::vector<Index2> quad_nodes(int order) {
  if (order == 0) return {{0, 0}};
  std::vector<Index2> nodes = {{0, 0}, {order, 0}, {order, order}, {0, order}};
  for (int i = 1; i < order; ++i) nodes.push_back({i, 0});
  for (int i = 1; i < order; ++i) nodes.push_back({order, i});
  for (int i = 1; i < order; ++i) nodes.push_back({order - i, order});
  for (int i = 1; i < order; ++i) nodes.push_back({0, order - i});
  if (order >= 2) {
    for (const auto& [i, j] : quad_nodes(order - 2)) {
      nodes.push_back({i + 1, j + 1});
    }
  }
  return nodes;
}

std::vector<Index3> hex_nodes(int order) {
  if (order == 0) return {{0, 0, 0}};
  std::vector<Index3> nodes;
  for (const Index3& c : kCorners) {
    nodes.push_back(lattice(order, c, c, 0, c, 0));
  }
  for (const auto& [from, to] : kEdges) {
    for (int i = 1; i < order; ++i) {
      nodes.push_back(
          lattice(order, corner(from), corner(to), i, corner(from), 0));
    }
  }
  if (order < 2) return nodes;
  for (const auto& [origin, first, second] : kFaces) {
    for (const auto& [i, j] : quad_nodes(order - 2)) {
      nodes.push_back(lattice(order, corner(origin), corner(first), i + 1,
                              corner(second), j + 1));
    }
  }
  for (const auto& [i, j, k] : hex_nodes(order - 2)) {
    nodes.push_back({i + 1, j + 1, k + 1});
  }
  return nodes;
}

}  // namespace

const ElementType* find_element_type(int id) {
  const auto found =
      std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& t) {
        return t.id == id;
      });
  return found == kTypes.end() ? nullptr : &*found;
}

int corner_count(ElementFamily family) {
  switch (family) {
    case F::kPoint:
      return 1;
    case F::kLine:
      return 2;
    case F::kTriangle:
      return 3;
    case F::kQuad:
    case F::kTetrahedron:
      return 4;
    case F::kHexahedron:
      return 8;
    case F::kOther:
      break;
  }
  return 0;
}

std::vector<int> hexahedron_node_order(int order) {
  std::vector<int> index;
  for (const auto& [i, j, k] : hex_nodes(order)) {
    index.push_back(i + (order + 1) * (j + (order + 1) * k));
  }
  return index;
}

std::vector<int> quadrangle_node_order(int order) {
  std::vector<int> index;
  for (const auto& [i, j] : quad_nodes(order)) {
    index.push_back(i + (order + 1) * j);
  }
  return index;
}

std::vector<int> tetrahedron_node_order(int order) {
  static constexpr std::array<Index2, 6> kMiddles = {
      {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}}};
  const auto lattice = simplex_lattice<3>(order);
  std::vector<int> position;
  const auto add = [&](int from, int to) {
    SimplexIndex<3> index{};
    index[std::size_t(from)] += order - order / 2;
    index[std::size_t(to)] += order / 2;
    position.push_back(int(std::find(lattice.begin(), lattice.end(), index) -
                           lattice.begin()));
  };
  for (int v = 0; v < 4; ++v) add(v, v);
  for (const auto& [from, to] : kMiddles) {
    if (order == 2) add(from, to);
  }
  return position;
}

Eigen::MatrixXd serendipity_to_complete() {
  const std::vector<Index3> nodes = hex_nodes(2);
  Eigen::MatrixXd value(27, 20);
  for (int a = 0; a < 20; ++a) {
    for (int q = 0; q < 27; ++q) {
      const Index3 at = {q % 3 - 1, q / 3 % 3 - 1, q / 9 - 1};
      double product = 1.0, sum = -2.0;
      for (std::size_t d = 0; d < 3; ++d) {
        const int centre = nodes[std::size_t(a)][d] - 1;
        product *= centre == 0 ? 1.0 - at[d] * at[d] : 1.0 + at[d] * centre;
        sum += at[d] * centre;
      }
      value(q, a) = a < 8 ? product * sum / 8.0 : product / 4.0;
    }
  }
  return value;
}

}  // namespace clevis::mesh
