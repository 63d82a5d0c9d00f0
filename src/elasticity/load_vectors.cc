#include "elasticity/load_vectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/errors.h"
#include "elasticity/dense_product.h"
#include "elasticity/group_trace.h"
#include "loads/discrete_balance.h"
#include "loads/seat_traction.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

template <int dim>
int find_group(const Discretization<dim>& discretization,
               const std::string& group, const std::string& part_name) {
  std::vector<std::string> names;
  for (std::size_t g = 0; g < discretization.groups.size(); ++g) {
    if (discretization.groups[g].name == group &&
        !discretization.group_faces[g].empty()) {
      return static_cast<int>(g);
    }
    names.push_back(discretization.groups[g].name);
  }
  throw Error("M003", "part " + part_name,
              fmt::format("the mesh has no surface group \"{}\"", group),
              fmt::format("groups of the mesh: {}", fmt::join(names, ", ")));
}

/// Tractions of all instants at the points of a group [Pa]: points × (dim ×
/// instants), instant after instant.
template <int dim>
class TractionHistory {
 public:
  TractionHistory(Index points, std::size_t instants)
      : values_(points, dim * static_cast<Index>(instants)) {}

  void set(std::size_t instant, const Matrix3Xd& tractions) {
    values_.middleCols<dim>(dim * static_cast<Index>(instant)) =
        tractions.topRows<dim>().transpose();
  }

  /// Adds ∫ N t dA to dofs × instants.
  void integrate(const GroupTrace& trace, MatrixXd& loads) const {
    Index begin = 0;
    for (const auto& face : trace.faces) {
      const Index n = face.values->rows();
      const MatrixXd weighted =
          trace.quadrature.weights.segment(begin, n).asDiagonal() *
          values_.middleRows(begin, n);
      const MatrixXd nodal = transposed_product(*face.values, weighted);
      for (std::size_t k = 0; k < face.nodes.size(); ++k) {
        for (Index i = 0; i < loads.cols(); ++i) {
          loads.col(i).segment<dim>(dim * face.nodes[k]) +=
              nodal.row(static_cast<Index>(k))
                  .template segment<dim>(dim * i)
                  .transpose();
        }
      }
      begin += n;
    }
  }

 private:
  MatrixXd values_;
};

/// Adds what is missing to the wanted resultant.
void correct(const loads::GroupQuadrature& quadrature,
             const loads::Wrench& wanted, const Vector3d& about,
             Matrix3Xd& tractions) {
  const auto missing = loads::correction(quadrature, tractions, wanted, about);
  for (Index q = 0; q < tractions.cols(); ++q) {
    tractions.col(q) += missing.traction(quadrature.points.col(q));
  }
}

template <int dim>
void add_seat(const Discretization<dim>& discretization,
              const loads::LoadHistory& history, std::size_t seat_index,
              const std::string& part_name, FaceTables<dim>& tables,
              MatrixXd& result) {
  const loads::Seat& seat = history.seats[seat_index];
  const int group = find_group(discretization, seat.group, part_name);
  const auto& cylinder =
      discretization.groups[static_cast<std::size_t>(group)].cylinder;
  if (seat.kind == loads::SeatKind::kBearing && !cylinder) {
    throw Error("L002", "part " + part_name + ", group " + seat.group,
                "a pin bears on this group, but it is no circular cylinder",
                "name the group bore_* or round_* if it is round");
  }
  const GroupTrace trace = group_trace(discretization, group, tables);
  const auto n = trace.quadrature.weights.size();
  TractionHistory<dim> history_here(n, history.instants.size());
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const loads::Wrench& wrench = history.instants[i].wrenches[seat_index];
    Matrix3Xd tractions = Matrix3Xd::Zero(3, n);
    if (seat.kind == loads::SeatKind::kBearing) {
      const loads::BearingTraction bearing(*cylinder, wrench);
      for (Index q = 0; q < n; ++q) {
        tractions.col(q) = bearing.traction(trace.quadrature.points.col(q),
                                            trace.outward.col(q));
      }
    }
    correct(trace.quadrature, wrench, seat.p_LS, tractions);
    history_here.set(i, tractions);
  }
  history_here.integrate(trace, result);
}

template <int dim>
void add_surface_loads(const Discretization<dim>& discretization,
                       const loads::LoadHistory& history, std::size_t index,
                       const std::string& part_name, FaceTables<dim>& tables,
                       MatrixXd& result) {
  const auto& name = history.instants.front().surface_loads[index].group;
  const GroupTrace trace = group_trace(
      discretization, find_group(discretization, name, part_name), tables);
  TractionHistory<dim> history_here(trace.quadrature.weights.size(),
                                    history.instants.size());
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const loads::SurfaceLoad& load = history.instants[i].surface_loads[index];
    Matrix3Xd tractions = -load.pressure * trace.outward;
    tractions.colwise() += load.traction;
    correct(trace.quadrature, load.resultant, Vector3d::Zero(), tractions);
    history_here.set(i, tractions);
  }
  history_here.integrate(trace, result);
}

/// ∫ N dV and ∫ N p dV per node: nodes × 4 (1, x, y, z), z the mid-plane's.
template <int dim>
MatrixXd node_moments(const Discretization<dim>& discretization) {
  const Degree points = discretization.shape == mesh::CellShape::kTensor
                            ? Degree(discretization.degree + 2,
                                     discretization.thickness_degree + 2)
                            : Degree(4);
  const auto rule = gauss<dim>(discretization.shape, points);
  const auto displacement = tabulate_displacement<dim>(
      discretization.shape, discretization.displacement_degree(), rule.points);
  const auto geometry = tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), rule.points);
  MatrixXd moments = MatrixXd::Zero(discretization.nodes, 4);
  MatrixXd factor(rule.weights.size(), 4);
  factor.col(3).setConstant(discretization.mid_plane_z);
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const auto at = cell_geometry<dim>(discretization.cell_points[c], geometry);
    const Eigen::VectorXd weights =
        rule.weights.cwiseProduct(at.determinant) * discretization.thickness;
    factor.col(0).setOnes();
    factor.middleCols<dim>(1) = at.points.transpose();
    const MatrixXd cell =
        transposed_product(displacement.values, weights.asDiagonal() * factor);
    const auto& nodes = discretization.cell_nodes[c];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      moments.row(nodes[i]) += cell.row(static_cast<Index>(i));
    }
  }
  return moments;
}

template <int dim>
void add_body_loads(const Discretization<dim>& discretization,
                    const loads::LoadHistory& history, double density,
                    MatrixXd& result) {
  const MatrixXd moments = node_moments(discretization);
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const loads::RigidAcceleration& rigid = history.instants[i].rigid;
    Eigen::Matrix<double, 4, 3> field;  // acceleration = (1, x, y, z) field
    field.row(0) = rigid.acceleration;
    for (int k = 0; k < 3; ++k) {
      const Vector3d e = Vector3d::Unit(k);
      field.row(1 + k) =
          rigid.alpha.cross(e) + rigid.omega.cross(rigid.omega.cross(e));
    }
    const MatrixXd load = -density * moments * field.leftCols<dim>();
    auto column = result.col(static_cast<Index>(i));
    for (Index node = 0; node < load.rows(); ++node) {
      column.segment<dim>(dim * node) += load.row(node).transpose();
    }
  }
}

/// Consistent mass times rigid motions (translations, rotations about Lo):
/// dofs × modes [kg], [kg m].
template <int dim>
MatrixXd rigid_inertia(const Discretization<dim>& discretization,
                       double density) {
  const MatrixXd moments = density * node_moments(discretization);
  MatrixXd inertia = MatrixXd::Zero(discretization.dofs(), dim == 2 ? 3 : 6);
  for (Index node = 0; node < moments.rows(); ++node) {
    auto at = inertia.middleRows<dim>(dim * node);
    at.template leftCols<dim>().diagonal().setConstant(moments(node, 0));
    const Vector3d arm = moments.row(node).tail<3>();
    if constexpr (dim == 2) {
      at.col(2) << -arm.y(), arm.x();
    } else {
      for (int k = 0; k < 3; ++k) at.col(3 + k) = Vector3d::Unit(k).cross(arm);
    }
  }
  return inertia;
}

}  // namespace

template <int dim>
MatrixXd assemble_loads(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, double density,
                        const std::string& part_name) {
  MatrixXd result = MatrixXd::Zero(discretization.dofs(),
                                   static_cast<Index>(history.instants.size()));
  FaceTables<dim> tables;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    add_seat(discretization, history, s, part_name, tables, result);
  }
  for (std::size_t s = 0; s < history.instants.front().surface_loads.size();
       ++s) {
    add_surface_loads(discretization, history, s, part_name, tables, result);
  }
  add_body_loads(discretization, history, density, result);
  return result;
}

template <int dim>
double balance_loads(const Discretization<dim>& discretization, double density,
                     const MatrixXd& modes, MatrixXd& history) {
  const double scale = history.cwiseAbs().colwise().sum().maxCoeff();
  if (!(scale > 0.0)) return 0.0;
  const MatrixXd residual = transposed_product(modes, history);
  const MatrixXd inertia = rigid_inertia(discretization, density);
  const MatrixXd acceleration =
      transposed_product(modes, inertia).fullPivLu().solve(residual);
  history -= product(inertia, acceleration);
  return residual.cwiseAbs().maxCoeff() / scale;
}

template double balance_loads<2>(const Discretization<2>&, double,
                                 const MatrixXd&, MatrixXd&);
template double balance_loads<3>(const Discretization<3>&, double,
                                 const MatrixXd&, MatrixXd&);
template MatrixXd assemble_loads<2>(const Discretization<2>&,
                                    const loads::LoadHistory&, double,
                                    const std::string&);
template MatrixXd assemble_loads<3>(const Discretization<3>&,
                                    const loads::LoadHistory&, double,
                                    const std::string&);

}  // namespace clevis::elasticity
