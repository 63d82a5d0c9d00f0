#include "stress/held_face.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "elasticity/dense_product.h"
#include "elasticity/group_trace.h"
#include "elasticity/stiffness.h"
#include "elasticity/supports.h"
#include "stress/cell_field.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// A plane face as the section of a bar.
struct Section {
  Vector3d centroid, normal;  ///< [m]; outward
  double area{};              ///< [m²]
  Matrix3d flexibility;  ///< inverse, in the plane, of ∫ r rᵀ dA [1/m⁴]
  double polar{};        ///< ∫ r² dA [m⁴]
};

/// Inverse of the second moments in the directions that the face has.
Matrix3d inverse_in_plane(const Matrix3d& moments) {
  constexpr double kNone = 1e-9;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(moments);
  Vector3d inverse = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    if (axes.eigenvalues()[k] > kNone * axes.eigenvalues()[2]) {
      inverse[k] = 1.0 / axes.eigenvalues()[k];
    }
  }
  return axes.eigenvectors() * inverse.asDiagonal() *
         axes.eigenvectors().transpose();
}

/// None if the faces of the group are not in one plane.
std::optional<Section> section_of(const elasticity::GroupTrace& trace) {
  constexpr double kPlane = 1e-6;
  const Matrix3Xd& points = trace.quadrature.points;
  const Eigen::VectorXd& weights = trace.quadrature.weights;
  if (weights.size() == 0) return std::nullopt;
  Section section;
  section.area = weights.sum();
  section.centroid = points * weights / section.area;
  section.normal = (trace.outward * weights).normalized();
  const Matrix3Xd arms = points.colwise() - section.centroid;
  const double size = arms.colwise().norm().maxCoeff();
  const Eigen::RowVectorXd along = section.normal.transpose() * arms;
  const bool is_plane =
      along.cwiseAbs().maxCoeff() <= kPlane * size &&
      (trace.outward.colwise() - section.normal).colwise().norm().maxCoeff() <=
          kPlane;
  if (!is_plane) return std::nullopt;
  const Matrix3d moments = arms * weights.asDiagonal() * arms.transpose();
  section.polar = moments.trace();
  section.flexibility = inverse_in_plane(moments);
  return section;
}

/// ∫ σ ∇N dV of cells.
template <int dim>
class NodalForces {
 public:
  NodalForces(const elasticity::Discretization<dim>& discretization,
              const part::Material& material)
      : discretization_(discretization),
        rule_(elasticity::stiffness_quadrature<dim>(discretization)),
        field_(discretization, material, rule_.points),
        geometry_(elasticity::tabulate_geometry<dim>(
            discretization.shape, discretization.mapping_degree(),
            rule_.points)),
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
  elasticity::Tabulation geometry_, displacement_;
};

struct Resultants {
  Matrix3Xd force, moment;  ///< about a point, 3 × columns
};

/// Reactions of the group's held components per basis column.
template <int dim>
Resultants reactions(const elasticity::DisplacementBasis<dim>& basis,
                     const part::Material& material, int group,
                     const std::array<bool, 3>& held, const Vector3d& about) {
  const auto& discretization = basis.discretization;
  const auto positions = elasticity::node_positions(discretization);
  const auto nodes = elasticity::group_nodes<dim>(discretization, group);
  const NodalForces<dim> forces_of(discretization, material);
  Resultants sum{Matrix3Xd::Zero(3, basis.columns.cols()),
                 Matrix3Xd::Zero(3, basis.columns.cols())};
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const auto& ids = discretization.cell_nodes[c];
    const auto is_held = [&](int node) {
      return std::ranges::binary_search(nodes, node);
    };
    if (std::ranges::none_of(ids, is_held)) continue;
    const MatrixXd forces = forces_of.of(c, basis.columns);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!is_held(ids[i])) continue;
      Matrix3Xd at_node = Matrix3Xd::Zero(3, basis.columns.cols());
      for (int a = 0; a < dim; ++a) {
        if (!held[static_cast<std::size_t>(a)]) continue;
        at_node.row(a) = forces.row(a * static_cast<Index>(ids.size()) +
                                    static_cast<Index>(i));
      }
      Vector3d arm = Vector3d::Zero();
      arm.head<dim>() = positions.col(ids[i]) - about.head<dim>();
      sum.force += at_node;
      sum.moment += at_node.colwise().cross(-arm);
    }
  }
  return sum;
}

/// Largest von Mises of the section's states per instant [Pa].
Eigen::VectorXd nominal_stress(const Section& section, const Matrix3Xd& force,
                               const Matrix3Xd& moment, const Matrix3Xd& at) {
  const Matrix3Xd arms = at.colwise() - section.centroid;
  const Eigen::ArrayXd far = arms.colwise().norm().transpose().array();
  Eigen::VectorXd nominal(force.cols());
  for (Index i = 0; i < force.cols(); ++i) {
    const Vector3d n = section.normal, f = force.col(i), m = moment.col(i);
    const double axial = f.dot(n) / section.area;
    const double shear = (f - f.dot(n) * n).norm() / section.area;
    const Vector3d slope = section.flexibility * n.cross(m);
    const Eigen::ArrayXd bent =
        axial + (slope.transpose() * arms).transpose().array();
    const double twist = m.dot(n) / section.polar;
    const double at_nodes =
        (bent.square() + 3.0 * (twist * far).square()).maxCoeff();
    nominal[i] =
        std::sqrt(std::max(at_nodes, axial * axial + 3.0 * shear * shear));
  }
  return nominal;
}

}  // namespace

template <int dim>
std::vector<HeldFace> held_faces(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material,
    const std::map<std::string, std::array<bool, 3>>& fixed) {
  const auto& discretization = basis.discretization;
  const auto positions = elasticity::node_positions(discretization);
  std::vector<HeldFace> faces;
  for (int g = 0; g < static_cast<int>(discretization.groups.size()); ++g) {
    const auto& name = discretization.groups[static_cast<std::size_t>(g)].name;
    const auto held = fixed.find(name);
    if (held == fixed.end()) continue;
    elasticity::FaceTables<dim> tables;
    const auto section =
        section_of(elasticity::group_trace(discretization, g, tables));
    if (!section) continue;
    const auto nodes = elasticity::group_nodes<dim>(discretization, g);
    Matrix3Xd at = Matrix3Xd::Constant(3, static_cast<Index>(nodes.size()),
                                       discretization.mid_plane_z);
    at.topRows<dim>() = positions(Eigen::all, nodes);
    const Resultants unit =
        reactions<dim>(basis, material, g, held->second, section->centroid);
    HeldFace face{name,
                  unit.force * basis.coefficients,
                  unit.moment * basis.coefficients,
                  {}};
    face.nominal = nominal_stress(*section, face.force, face.moment, at);
    faces.push_back(std::move(face));
  }
  return faces;
}

template std::vector<HeldFace> held_faces<2>(
    const elasticity::DisplacementBasis<2>&, const part::Material&,
    const std::map<std::string, std::array<bool, 3>>&);
template std::vector<HeldFace> held_faces<3>(
    const elasticity::DisplacementBasis<3>&, const part::Material&,
    const std::map<std::string, std::array<bool, 3>>&);

}  // namespace clevis::stress
