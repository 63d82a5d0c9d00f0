#include "elasticity/mirror_symmetry/folding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elasticity/assembly/supports.h"
#include "elasticity/direct/dissection.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Sign that component `axis` of a class takes behind the mirrors `behind`.
template <int dim>
double sign(const Folding<dim>& folding, unsigned parity, unsigned behind,
            int axis) {
  bool negative = false;
  for (std::size_t k = 0; k < folding.mirrors.size(); ++k) {
    if (((behind >> k) & 1U) == 0) continue;
    const bool odd = ((parity >> k) & 1U) != 0;
    negative ^= odd != (folding.mirrors[k].axis == axis);
  }
  return negative ? -1.0 : 1.0;
}

/// The signs of all components behind all combinations of mirrors.
template <int dim>
std::vector<std::array<double, dim>> signs(const Folding<dim>& folding,
                                           unsigned parity) {
  std::vector<std::array<double, dim>> result(folding.classes());
  for (unsigned behind = 0; behind < folding.classes(); ++behind) {
    for (int a = 0; a < dim; ++a) {
      result[behind][static_cast<std::size_t>(a)] =
          sign(folding, parity, behind, a);
    }
  }
  return result;
}

/// Which nodes of the whole part the cells on the low side have.
template <int dim>
std::vector<std::size_t> low_cells(
    const Discretization<dim>& whole,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions,
    const std::vector<Mirror>& mirrors) {
  std::vector<std::size_t> cells;
  for (std::size_t c = 0; c < whole.cell_nodes.size(); ++c) {
    Eigen::Matrix<double, dim, 1> sum = Eigen::Matrix<double, dim, 1>::Zero();
    for (int i : whole.cell_nodes[c]) sum += positions.col(i);
    const auto n = static_cast<double>(whole.cell_nodes[c].size());
    const bool low = std::ranges::all_of(mirrors, [&](const Mirror& mirror) {
      return sum[mirror.axis] < n * mirror.position;
    });
    if (low) cells.push_back(c);
  }
  return cells;
}

template <int dim>
void take_cells(const Discretization<dim>& whole,
                const std::vector<std::size_t>& cells, Folding<dim>& folding) {
  Discretization<dim>& part = folding.part;
  std::vector<int> number(static_cast<std::size_t>(whole.nodes), -1);
  for (std::size_t c : cells) {
    for (int i : whole.cell_nodes[c]) number[static_cast<std::size_t>(i)] = 0;
  }
  part.nodes = 0;
  for (int& n : number) {
    if (n == 0) n = part.nodes++;
  }
  part.cell_nodes.clear();
  part.cell_points.clear();
  for (std::size_t c : cells) {
    auto nodes = whole.cell_nodes[c];
    for (int& i : nodes) i = number[static_cast<std::size_t>(i)];
    part.cell_nodes.push_back(std::move(nodes));
    part.cell_points.push_back(whole.cell_points[c]);
  }
  for (int& i : part.vertex_nodes) {
    if (i >= 0) i = number[static_cast<std::size_t>(i)];
  }
  // The factorisation permutes nothing.
  std::vector<int> place;
  folding.dissection = dissect_and_renumber(part, place);
  for (int& n : number) {
    if (n >= 0) n = place[static_cast<std::size_t>(n)];
  }
  folding.node = std::move(number);
}

/// Puts onto the planes what the mesh, symmetric to a tolerance only, has
/// beside them. A class holds its components there; held off the plane by δ,
/// they would take δ over the part's size of the moments too, and leave as much
/// to the supports of a free part, which may not carry anything.
template <int dim>
void snap_to_planes(const std::vector<Mirror>& mirrors,
                    Discretization<dim>& part) {
  for (auto& points : part.cell_points) {
    for (const Mirror& mirror : mirrors) {
      for (double& x : points.row(mirror.axis)) {
        if (std::abs(x - mirror.position) < mirror.tolerance) {
          x = mirror.position;
        }
      }
    }
  }
}

}  // namespace

template <int dim>
Folding<dim> fold(const Discretization<dim>& whole,
                  const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions,
                  std::vector<Mirror> mirrors) {
  Folding<dim> folding;
  folding.part = whole;
  folding.part.group_faces.clear();
  folding.part.groups.clear();
  folding.mirrors = std::move(mirrors);
  take_cells(whole, low_cells<dim>(whole, positions, folding.mirrors), folding);
  snap_to_planes<dim>(folding.mirrors, folding.part);
  std::vector<int> node(static_cast<std::size_t>(whole.nodes));
  folding.behind.assign(node.size(), 0);
  folding.on_plane.assign(static_cast<std::size_t>(folding.part.nodes), 0);
  for (std::size_t i = 0; i < node.size(); ++i) {
    std::size_t low = i;
    unsigned on_plane = 0;
    for (std::size_t k = 0; k < folding.mirrors.size(); ++k) {
      const Mirror& mirror = folding.mirrors[k];
      const auto image = static_cast<std::size_t>(mirror.partner[low]);
      if (image == low) {
        on_plane |= 1U << k;
      } else if (positions(mirror.axis, static_cast<Index>(low)) >
                 mirror.position) {
        folding.behind[i] |= 1U << k;
        low = image;
      }
    }
    node[i] = folding.node[low];
    folding.on_plane[static_cast<std::size_t>(node[i])] = on_plane;
  }
  folding.node = std::move(node);
  return folding;
}

template <int dim>
MatrixXd loads_of_class(const Folding<dim>& folding, unsigned parity,
                        const MatrixXd& whole) {
  const auto sign_of = signs(folding, parity);
  const double share = 1.0 / folding.classes();
  MatrixXd folded = MatrixXd::Zero(folding.part.dofs(), whole.cols());
  for (Index column = 0; column < whole.cols(); ++column) {
    const double* from = whole.col(column).data();
    double* to = folded.col(column).data();
    for (std::size_t i = 0; i < folding.node.size(); ++i) {
      const auto& s = sign_of[folding.behind[i]];
      const auto n = static_cast<std::size_t>(folding.node[i]);
      for (std::size_t a = 0; a < dim; ++a) {
        to[dim * n + a] += share * s[a] * from[dim * i + a];
      }
    }
  }
  for (int dof : held_on_planes(folding, parity)) folded.row(dof).setZero();
  return folded;
}

template <int dim>
void add_unfolded(const Folding<dim>& folding, unsigned parity,
                  const MatrixXd& folded, MatrixXd& whole) {
  const auto sign_of = signs(folding, parity);
  for (Index column = 0; column < whole.cols(); ++column) {
    const double* from = folded.col(column).data();
    double* to = whole.col(column).data();
    for (std::size_t i = 0; i < folding.node.size(); ++i) {
      const auto& s = sign_of[folding.behind[i]];
      const auto n = static_cast<std::size_t>(folding.node[i]);
      for (std::size_t a = 0; a < dim; ++a) {
        to[dim * i + a] += s[a] * from[dim * n + a];
      }
    }
  }
}

template <int dim>
std::vector<int> held_on_planes(const Folding<dim>& folding, unsigned parity) {
  std::vector<int> held;
  for (int node = 0; node < folding.part.nodes; ++node) {
    const unsigned planes = folding.on_plane[static_cast<std::size_t>(node)];
    for (int a = 0; a < dim && planes != 0; ++a) {
      bool zero = false;
      for (std::size_t k = 0; k < folding.mirrors.size(); ++k) {
        const unsigned plane = planes & (1U << k);
        zero |= sign(folding, parity, plane, a) < 0.0;
      }
      if (zero) held.push_back(dim * node + a);
    }
  }
  return held;
}

template <int dim>
std::vector<int> rigid_modes_of(const Folding<dim>& folding, unsigned parity) {
  std::vector<int> modes;
  for (int mode = 0; mode < kRigidModes<dim>; ++mode) {
    bool belongs = true;
    for (std::size_t k = 0; k < folding.mirrors.size(); ++k) {
      const int axis = folding.mirrors[k].axis;
      // A rotation about the normal keeps its sense in the mirror, another
      // one reverses it: the opposite of translations.
      const bool even =
          mode < dim ? axis != mode : dim == 3 && axis == mode - dim;
      belongs &= even == (((parity >> k) & 1U) == 0);
    }
    if (belongs) modes.push_back(mode);
  }
  return modes;
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template Folding<dim> fold<dim>(                                             \
      const Discretization<dim>&,                                              \
      const Eigen::Matrix<double, dim, Eigen::Dynamic>&, std::vector<Mirror>); \
  template MatrixXd loads_of_class<dim>(const Folding<dim>&, unsigned,         \
                                        const MatrixXd&);                      \
  template void add_unfolded<dim>(const Folding<dim>&, unsigned,               \
                                  const MatrixXd&, MatrixXd&);                 \
  template std::vector<int> held_on_planes<dim>(const Folding<dim>&,           \
                                                unsigned);                     \
  template std::vector<int> rigid_modes_of<dim>(const Folding<dim>&, unsigned);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
