#include "stress/sections/support_face.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "part/supports.h"
#include "stress/field/cell_field.h"
#include "stress/sections/support_piece.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// ∫ σ ∇N dV of cells.
template <int dim>
class NodalForces {
 public:
  NodalForces(const elasticity::Discretization<dim>& discretization,
              const part::Material& material)
      : discretization_(discretization),
        rule_(elasticity::stiffness_quadrature<dim>(discretization)),
        field_(discretization, material, rule_.points),
        geometry_(discretization.shape, discretization.mapping_degree(),
                  rule_.points),
        displacement_(elasticity::tabulate_displacement<dim>(
            discretization.shape, discretization.displacement_degree(),
            rule_.points)) {}

  /// Per component the cell's nodes, below each other, × columns [N].
  MatrixXd of(std::size_t cell, const MatrixXd& columns) const {
    static constexpr int kStress[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    const auto at = elasticity::cell_geometry<dim>(
        discretization_.cell_points[cell], geometry_);
    const auto gradients =
        elasticity::physical_gradients<dim>(at, displacement_);
    const Eigen::VectorXd weights =
        discretization_.thickness * at.determinant.cwiseProduct(rule_.weights);
    const MatrixXd stress = field_.stress(cell, columns);
    const Index n = weights.size(), nodes = gradients[0].cols();
    MatrixXd forces = MatrixXd::Zero(dim * nodes, columns.cols());
    for (int a = 0; a < dim; ++a) {
      for (int b = 0; b < dim; ++b) {
        const int k = dim == 2 ? (a == b ? a : 2) : kStress[a][b];
        forces.middleRows(a * nodes, nodes) += elasticity::transposed_product(
            gradients[static_cast<std::size_t>(b)],
            weights.asDiagonal() * stress.middleRows(k * n, n));
      }
    }
    return forces;
  }

 private:
  const elasticity::Discretization<dim>& discretization_;
  elasticity::Quadrature<dim> rule_;
  CellField<dim> field_;
  elasticity::CellInterpolation<dim> geometry_;
  elasticity::Tabulation displacement_;
};

/// ∫ σ ∇N dV of nodes less their loads, per node and basis column; loads are
/// columns of their own behind. All components: what is not held carries
/// nothing, or lies on an elastic bed.
template <int dim>
std::map<int, Matrix3Xd> reactions(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material, const std::vector<SupportPiece>& pieces,
    const elasticity::SplitColumns& loads) {
  const Index rank = basis.columns.cols();
  std::map<int, Matrix3Xd> found;
  for (const SupportPiece& piece : pieces) {
    for (const int node : piece.nodes) {
      Matrix3Xd& at = found[node];
      at = Matrix3Xd::Zero(3, rank + loads.cols());
      at.topRightCorner(dim, loads.cols()) =
          -loads.middle_rows(dim * Index{node}, dim);
    }
  }
  const NodalForces<dim> forces_of(basis.discretization, material);
  const auto& cells = basis.discretization.cell_nodes;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto& ids = cells[c];
    if (std::ranges::none_of(ids, [&](int node) {
          return found.contains(node);
        })) {
      continue;
    }
    const MatrixXd forces = forces_of.of(c, basis.columns);
    const auto count = static_cast<Index>(ids.size());
    for (Index i = 0; i < count; ++i) {
      const auto node = found.find(ids[static_cast<std::size_t>(i)]);
      if (node == found.end()) continue;
      for (int a = 0; a < dim; ++a) {
        node->second.row(a).head(rank) += forces.row(a * count + i);
      }
    }
  }
  return found;
}

/// The history without what acts on held faces themselves: it goes on into the
/// part with the support's reaction, or no farther than the support.
loads::LoadHistory without_loads_on(const std::vector<SupportPiece>& pieces,
                                    loads::LoadHistory history) {
  const auto is_held = [&pieces](const std::string& group) {
    return std::ranges::any_of(pieces, [&group](const SupportPiece& piece) {
      return std::ranges::find(piece.groups, group) != piece.groups.end();
    });
  };
  for (loads::InstantLoad& instant : history.instants) {
    for (std::size_t s = 0; s < history.seats.size(); ++s) {
      if (is_held(history.seats[s].group)) instant.wrenches[s] = {};
    }
    for (loads::SurfaceLoad& load : instant.surface_loads) {
      if (!is_held(load.group)) continue;
      const std::string group = load.group;
      load = {};
      load.group = group;
    }
  }
  return history;
}

/// "root", "left + right", "feet at (0, 4, 0) mm" of several.
std::string name_of(const SupportPiece& piece,
                    const std::vector<SupportPiece>& pieces) {
  std::string name;
  for (const auto& group : piece.groups) {
    name += (name.empty() ? "" : " + ") + group;
  }
  const auto alike =
      std::ranges::count(pieces, piece.groups, &SupportPiece::groups);
  if (alike == 1) return name;
  const Vector3d at = 1e3 * piece.section.centroid;
  return fmt::format("{} at ({:.4g}, {:.4g}, {:.4g}) mm", name, at.x(), at.y(),
                     at.z());
}

}  // namespace

template <int dim>
std::vector<SupportFace> support_faces(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material, const part::Supports& fixed,
    const loads::LoadHistory& history, const std::string& part_name) {
  const auto& discretization = basis.discretization;
  const auto pieces = support_pieces<dim>(discretization, fixed);
  if (pieces.empty()) return {};
  elasticity::SplitLoads loads{elasticity::SplitColumns(discretization.dofs()),
                               MatrixXd(0, basis.coefficients.cols())};
  if (!history.instants.empty()) {
    loads = elasticity::load_columns<dim>(discretization,
                                          without_loads_on(pieces, history),
                                          material.density, part_name);
  }
  const Index rank = basis.columns.cols();
  MatrixXd coefficients(rank + loads.columns.cols(), basis.coefficients.cols());
  coefficients << basis.coefficients, loads.coefficients;
  const auto at_node = reactions<dim>(basis, material, pieces, loads.columns);
  const auto positions = elasticity::node_positions(discretization);
  std::vector<SupportFace> faces;
  for (const SupportPiece& piece : pieces) {
    Matrix3Xd force = Matrix3Xd::Zero(3, coefficients.rows());
    Matrix3Xd moment = force;
    for (const int node : piece.nodes) {
      Vector3d arm = Vector3d::Zero();
      arm.head<dim>() =
          positions.col(node) - piece.section.centroid.head<dim>();
      const Matrix3Xd& reaction = at_node.at(node);
      force += reaction;
      moment += reaction.colwise().cross(-arm);
    }
    SupportFace face{name_of(piece, pieces),
                     piece.groups,
                     force * coefficients,
                     moment * coefficients,
                     {}};
    face.nominal =
        nominal_stress(piece.section, face.force, face.moment, piece.extremes);
    faces.push_back(std::move(face));
  }
  return faces;
}

#define CLEVIS_INSTANTIATE(dim)                                         \
  template std::vector<SupportFace> support_faces<dim>(                 \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, \
      const part::Supports&, const loads::LoadHistory&, const std::string&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)

}  // namespace clevis::stress
