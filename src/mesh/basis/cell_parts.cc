#include "mesh/basis/cell_parts.h"

#include <cstddef>

namespace clevis::mesh {
namespace {

std::vector<CellPart> parts_of_square() {
  return {{0, {}},    {1, {}},  {2, {}},  {3, {}},   // corners
          {0, {1}},   {1, {1}}, {0, {0}}, {2, {0}},  // edges
          {0, {0, 1}}};                              // inside
}

std::vector<CellPart> parts_of_cube() {
  std::vector<CellPart> parts;
  for (unsigned corner = 0; corner < 8; ++corner) parts.push_back({corner, {}});
  for (const unsigned lid : {0U, 4U}) {
    for (const unsigned x : {0U, 1U}) parts.push_back({lid + x, {1}});
    for (const unsigned y : {0U, 2U}) parts.push_back({lid + y, {0}});
  }
  for (unsigned foot = 0; foot < 4; ++foot) parts.push_back({foot, {2}});
  for (int normal = 0; normal < 3; ++normal) {
    for (const unsigned side : {0U, 1U << normal}) {
      parts.push_back({side, {(normal + 1) % 3, (normal + 2) % 3}});
    }
  }
  parts.push_back({0, {0, 1, 2}});
  return parts;
}

}  // namespace

template <int dim>
const std::vector<CellPart>& cell_parts() {
  static const std::vector<CellPart> parts =
      dim == 2 ? parts_of_square() : parts_of_cube();
  return parts;
}

unsigned corner_of(const CellPart& part, unsigned of_part) {
  unsigned corner = part.corner;
  for (std::size_t k = 0; k < part.along.size(); ++k) {
    corner |= ((of_part >> k) & 1U) << part.along[k];
  }
  return corner;
}

template <int dim>
std::vector<unsigned> lexicographic_numbers(int degree) {
  const auto p = static_cast<unsigned>(degree);
  unsigned stride[dim];
  unsigned count = 1;
  for (unsigned& s : stride) {
    s = count;
    count *= p + 1;
  }
  std::vector<unsigned> numbers;
  numbers.reserve(count);
  for (const CellPart& part : cell_parts<dim>()) {
    unsigned first = 0;
    for (int d = 0; d < dim; ++d) {
      if (((part.corner >> d) & 1U) != 0) first += p * stride[d];
    }
    std::vector<unsigned> nodes{first};
    for (const int direction : part.along) {
      std::vector<unsigned> further;
      for (unsigned k = 1; k < p; ++k) {
        for (const unsigned node : nodes) {
          further.push_back(node + k * stride[direction]);
        }
      }
      nodes = std::move(further);
    }
    numbers.insert(numbers.end(), nodes.begin(), nodes.end());
  }
  return numbers;
}

template const std::vector<CellPart>& cell_parts<2>();
template const std::vector<CellPart>& cell_parts<3>();
template std::vector<unsigned> lexicographic_numbers<2>(int);
template std::vector<unsigned> lexicographic_numbers<3>(int);

}  // namespace clevis::mesh
