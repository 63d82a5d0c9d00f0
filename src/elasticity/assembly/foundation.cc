#include "elasticity/assembly/foundation.h"

#include <algorithm>
#include <utility>

#include "base/messages/errors.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/fe_space/group_trace.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
int group_of(const Discretization<dim>& discretization, const std::string& name,
             const std::string& part_name) {
  for (std::size_t g = 0; g < discretization.groups.size(); ++g) {
    if (discretization.groups[g].name == name) return static_cast<int>(g);
  }
  throw Error("M003", "part " + part_name,
              "the mesh has no surface group \"" + name + "\"",
              "Name a group of the mesh under `foundation`.");
}

/// Rows dim·node + component of the columns.
template <int dim>
MatrixXd gather(const std::vector<int>& nodes, const MatrixXd& columns) {
  MatrixXd result(dim * static_cast<Index>(nodes.size()), columns.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    result.middleRows<dim>(dim * static_cast<Index>(i)) =
        columns.middleRows<dim>(dim * nodes[i]);
  }
  return result;
}

}  // namespace

template <int dim>
FoundationStiffness<dim>::FoundationStiffness(
    const Discretization<dim>& discretization,
    const part::Foundations& foundations, const std::string& part_name) {
  FaceTables<dim> tables;
  for (const auto& [name, bed] : foundations) {
    const int group = group_of<dim>(discretization, name, part_name);
    const GroupTrace trace = group_trace<dim>(discretization, group, tables);
    auto place =
        discretization.group_faces[static_cast<std::size_t>(group)].begin();
    Index q = 0;
    for (const auto& face : trace.faces) {
      const MatrixXd& N = *face.values;
      Face entry{(place++)->cell, face.nodes,
                 MatrixXd::Zero(dim * N.cols(), dim * N.cols())};
      for (Index k = 0; k < N.rows(); ++k, ++q) {
        const Eigen::Matrix<double, dim, 1> n =
            trace.outward.col(q).template head<dim>();
        const Eigen::Matrix<double, dim, dim> bedding =
            trace.quadrature.weights[q] *
            (bed.tangential * Eigen::Matrix<double, dim, dim>::Identity() +
             (bed.normal - bed.tangential) * n * n.transpose());
        for (Index i = 0; i < N.cols(); ++i) {
          for (Index j = 0; j < N.cols(); ++j) {
            entry.matrix.template block<dim, dim>(dim * i, dim * j) +=
                N(k, i) * N(k, j) * bedding;
          }
        }
      }
      faces_.push_back(std::move(entry));
    }
  }
}

template <int dim>
void FoundationStiffness<dim>::keep(const std::vector<int>& cells) {
  std::erase_if(faces_, [&](const Face& face) {
    return !std::ranges::binary_search(cells, face.cell);
  });
}

template <int dim>
void FoundationStiffness<dim>::renumber(const std::vector<int>& node) {
  for (Face& face : faces_) {
    for (int& n : face.nodes) n = node[static_cast<std::size_t>(n)];
  }
}

template <int dim>
void FoundationStiffness<dim>::add_to(StiffnessMatrix<dim>& stiffness) const {
  for (const Face& face : faces_) {
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      const auto row = static_cast<std::size_t>(face.nodes[i]);
      const auto begin = stiffness.column.begin() + stiffness.row_start[row];
      const auto end = stiffness.column.begin() + stiffness.row_start[row + 1];
      for (std::size_t j = 0; j < face.nodes.size(); ++j) {
        if (face.nodes[j] < face.nodes[i]) continue;  // the upper half
        const auto at = std::lower_bound(begin, end, face.nodes[j]);
        stiffness
            .block[static_cast<std::size_t>(at - stiffness.column.begin())] +=
            face.matrix.template block<dim, dim>(dim * static_cast<Index>(i),
                                                 dim * static_cast<Index>(j));
      }
    }
  }
}

template <int dim>
void FoundationStiffness<dim>::add_forces(const MatrixXd& columns,
                                          MatrixXd& forces) const {
  for (const Face& face : faces_) {
    const MatrixXd f = product(face.matrix, gather<dim>(face.nodes, columns));
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      forces.middleRows<dim>(dim * face.nodes[i]) +=
          f.middleRows<dim>(dim * static_cast<Index>(i));
    }
  }
}

template <int dim>
MatrixXd FoundationStiffness<dim>::on_modes(const MatrixXd& modes) const {
  MatrixXd result = MatrixXd::Zero(modes.cols(), modes.cols());
  for (const Face& face : faces_) {
    const MatrixXd here = gather<dim>(face.nodes, modes);
    result += here.transpose() * face.matrix * here;
  }
  return result;
}

template class FoundationStiffness<2>;
template class FoundationStiffness<3>;

}  // namespace clevis::elasticity
