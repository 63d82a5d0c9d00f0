#include "elasticity/revolution/harmonic_loads.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/messages/errors.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/sliding_tractions.h"
#include "elasticity/nodal_loads/zone_trace.h"
#include "loads/pressure/discrete_balance.h"
#include "loads/pressure/face_pressure.h"
#include "loads/pressure/seat_traction.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using std::numbers::pi;

int find_group(const Discretization<2>& meridian, const std::string& group,
               const std::string& part_name) {
  std::vector<std::string> names;
  for (std::size_t g = 0; g < meridian.groups.size(); ++g) {
    if (meridian.groups[g].name == group && !meridian.group_faces[g].empty()) {
      return static_cast<int>(g);
    }
    names.push_back(meridian.groups[g].name);
  }
  throw Error("M003", "part " + part_name,
              fmt::format("the mesh has no surface group \"{}\"", group),
              fmt::format("Groups of the mesh: {}.", fmt::join(names, ", ")));
}

/// A group's quadrature on the meridian, spread over the sample angles:
/// point q at angle k is column kAngles q + k.
struct RingTrace {
  GroupTrace trace;
  Eigen::VectorXd arc;  ///< weight times radius per meridian point [m²]
  loads::GroupQuadrature ring;
  Matrix3Xd outward;

  RingTrace(const mesh::Revolution& solid, GroupTrace meridian_trace)
      : trace(std::move(meridian_trace)) {
    const auto& q2 = trace.quadrature;
    const Index n = q2.weights.size();
    arc = q2.weights.cwiseProduct(q2.points.row(1).transpose());
    ring.points.resize(3, kAngles * n);
    ring.weights.resize(kAngles * n);
    outward.resize(3, kAngles * n);
    for (Index q = 0; q < n; ++q) {
      for (int k = 0; k < kAngles; ++k) {
        const double angle = sample_angle(k);
        const Index column = kAngles * q + k;
        ring.points.col(column) = solid.at(q2.points.col(q).head<2>(), angle);
        ring.weights[column] = arc[q] * 2.0 * pi / kAngles;
        outward.col(column) =
            solid.at(trace.outward.col(q).head<2>(), angle) - solid.origin;
      }
    }
  }
};

/// Share of order n ≥ 2 in max(0, cos ψ) = Σ c_n cos nψ.
double bearing_share(int order) {
  if (order % 2 == 1) return 0.0;
  const double sign = order / 2 % 2 == 1 ? 1.0 : -1.0;
  return 2.0 / pi * sign / (order * order - 1.0);
}

class Assembly {
 public:
  Assembly(const Discretization<2>& meridian, const mesh::Revolution& solid,
           const loads::LoadHistory& history, const std::string& part_name,
           int highest)
      : meridian_(meridian),
        solid_(solid),
        history_(history),
        part_name_(part_name),
        instants_(static_cast<Index>(history.instants.size())) {
    std::set<int> bearing_nodes;
    for (const auto& seat : history.seats) {
      if (seat.kind != loads::SeatKind::kBearing) continue;
      const int group = find_group(meridian, seat.group, part_name);
      for (int node : group_nodes(meridian, group)) bearing_nodes.insert(node);
    }
    std::vector<int> all(static_cast<std::size_t>(meridian.nodes));
    std::iota(all.begin(), all.end(), 0);
    for (const Harmonic& harmonic : linear_harmonics()) start(harmonic, all);
    const std::vector<int> some(bearing_nodes.begin(), bearing_nodes.end());
    for (int order = 4; order <= highest && !some.empty(); order += 2) {
      start({order, false}, some);
      start({order, true}, some);
    }
  }

  void add_seat(std::size_t index) {
    const loads::Seat& seat = history_.seats[index];
    const int group = find_group(meridian_, seat.group, part_name_);
    const auto& cylinder =
        meridian_.groups[static_cast<std::size_t>(group)].cylinder;
    const bool bears = seat.kind == loads::SeatKind::kBearing;
    if (bears && !cylinder) {
      throw Error("L002", "part " + part_name_ + ", group " + seat.group,
                  "a pin bears on this group, but it is no circular cylinder",
                  "Name the group bore_* or round_* if it is round.");
    }
    if (seat.slide) {
      add_sliding(index, group, *cylinder);
      return;
    }
    const RingTrace trace(solid_, group_trace(meridian_, group, tables_));
    loads::WallMoments wall;
    if (bears)
      wall = loads::wall_of(*cylinder, trace.ring.points, trace.ring.weights);
    for (Index i = 0; i < instants_; ++i) {
      const loads::Wrench& wrench =
          history_.instants[static_cast<std::size_t>(i)].wrenches[index];
      Matrix3Xd tractions = Matrix3Xd::Zero(3, trace.ring.weights.size());
      if (bears) {
        add_bearing({*cylinder, wrench, wall}, cylinder->radius, trace, i,
                    tractions);
      } else if (seat.kind == loads::SeatKind::kPressure) {
        tractions =
            loads::face_pressure(trace.ring, trace.outward, wrench.force);
      }
      add_tractions(trace, wrench, seat.p_LS, tractions, i);
    }
  }

  void add_surface(std::size_t index) {
    const auto& name = history_.instants.front().surface_loads[index].group;
    const RingTrace trace(
        solid_, group_trace(meridian_, find_group(meridian_, name, part_name_),
                            tables_));
    for (Index i = 0; i < instants_; ++i) {
      const auto& load =
          history_.instants[static_cast<std::size_t>(i)].surface_loads[index];
      Matrix3Xd tractions = -load.pressure * trace.outward;
      tractions.colwise() += load.traction;
      add_tractions(trace, load.resultant, Vector3d::Zero(), tractions, i);
    }
  }

  void add_body(double density, const MatrixXd& moments) {
    MatrixXd coefficients(12, instants_);
    for (Index i = 0; i < instants_; ++i) {
      const auto& rigid = history_.instants[static_cast<std::size_t>(i)].rigid;
      const auto turn = [&](const Vector3d& p) -> Vector3d {
        return rigid.alpha.cross(p) + rigid.omega.cross(rigid.omega.cross(p));
      };
      Matrix3d slope;
      for (int k = 0; k < 3; ++k) slope.col(k) = turn(solid_.axes.col(k));
      const Vector3d value = rigid.acceleration + turn(solid_.origin);
      coefficients.col(i) =
          -density * linear_coefficients(solid_.axes.transpose() * value,
                                         solid_.axes.transpose() * slope);
    }
    for (int h = 0; h < kLinearHarmonics; ++h) {
      auto& load = loads_[static_cast<std::size_t>(h)];
      load.values +=
          product(linear_columns(load.harmonic, moments), coefficients);
    }
  }

  /// Terms that are more than round-off; one of zeros if nothing loads.
  std::vector<HarmonicLoad> loaded() {
    constexpr double kRoundOff = 1e-13;
    double largest = 0.0;
    for (const auto& load : loads_) {
      largest = std::max(largest, load.values.norm());
    }
    if (!(largest > 0.0)) loads_.resize(1);
    std::erase_if(loads_, [&](const HarmonicLoad& load) {
      return load.values.norm() < kRoundOff * largest;
    });
    return std::move(loads_);
  }

 private:
  /// Of a guide on the length of a cylinder that it touches.
  void add_sliding(std::size_t index, int group, const part::Bore& cylinder) {
    const loads::Seat& seat = history_.seats[index];
    const WallFaces<2> wall(meridian_, {group}, tables_);
    const SlidingTractions sliding(history_, index, cylinder, part_name_);
    for (Index i = 0; i < instants_; ++i) {
      const auto instant = static_cast<std::size_t>(i);
      const loads::ContactZone zone = sliding.zone(instant);
      const ZoneTrace<2> cut(wall, on_meridian(bounds_of(seat, zone)));
      const RingTrace trace(solid_, cut.trace());
      const loads::Wrench& wrench = history_.instants[instant].wrenches[index];
      Matrix3Xd tractions = Matrix3Xd::Zero(3, trace.ring.weights.size());
      add_bearing(sliding.bearing(instant), cylinder.radius, trace, i,
                  tractions);
      add_tractions(trace, wrench, seat.p_LS, tractions, i);
    }
  }

  /// Half-spaces across the axis in the meridian's coordinates.
  std::vector<HalfSpace> on_meridian(std::vector<HalfSpace> bounds) const {
    for (HalfSpace& bound : bounds) {
      bound.offset -= bound.normal.dot(solid_.origin);
      bound.normal = {bound.normal.dot(solid_.axes.col(0)), 0.0, 0.0};
    }
    return bounds;
  }

  void add_bearing(const loads::BearingTraction& bearing, double radius,
                   const RingTrace& trace, Index instant,
                   Matrix3Xd& tractions) {
    add_low_terms(bearing, radius, trace, tractions);
    add_high_terms(bearing, radius, trace, instant);
  }

  void start(const Harmonic& harmonic, const std::vector<int>& nodes) {
    loads_.push_back(
        {harmonic, nodes,
         MatrixXd::Zero(3 * static_cast<Index>(nodes.size()), instants_)});
  }

  /// The bearing pressure's orders 0 and 1, and its shear.
  static void add_low_terms(const loads::BearingTraction& bearing,
                            double radius, const RingTrace& trace,
                            Matrix3Xd& tractions) {
    for (Index c = 0; c < tractions.cols(); ++c) {
      const Vector3d point = trace.ring.points.col(c);
      const Vector3d normal = trace.outward.col(c);
      const Vector3d w = bearing.line_load(point);
      const double pressure =
          2.0 / (pi * radius) * (w.norm() / pi - 0.5 * normal.dot(w));
      tractions.col(c) = -pressure * normal + bearing.shear(point);
    }
  }

  /// Its even orders from 2 on, with their amplitudes in closed form.
  void add_high_terms(const loads::BearingTraction& bearing, double radius,
                      const RingTrace& trace, Index instant) {
    const Index n = trace.arc.size();
    Eigen::VectorXd pressure(n), from(n);
    double side = 1.0;  // of the normal: away from the axis or to it
    for (Index q = 0; q < n; ++q) {
      side = trace.trace.outward(1, q) > 0.0 ? 1.0 : -1.0;
      const Vector3d w =
          -side * (solid_.axes.transpose() *
                   bearing.line_load(trace.ring.points.col(kAngles * q)));
      pressure[q] = 2.0 / (pi * radius) * w.norm();
      from[q] = std::atan2(w.z(), w.y());
    }
    for (auto& load : loads_) {
      const int order = load.harmonic.order;
      if (order < 2) continue;
      MatrixXd weighted = MatrixXd::Zero(n, 3);
      for (Index q = 0; q < n; ++q) {
        const double part = load.harmonic.is_sine ? std::sin(order * from[q])
                                                  : std::cos(order * from[q]);
        const double radial = -side * bearing_share(order) * pressure[q] * part;
        // ∮ cos² nθ dθ = π, and half of √2 each for u_+ and u_−
        weighted(q, 1) = radial * pi * trace.arc[q] / std::numbers::sqrt2;
        weighted(q, 2) = weighted(q, 1);
      }
      scatter(trace.trace, weighted, load, instant);
    }
  }

  /// Adds tractions of orders 0 to 2, put right to their resultant.
  void add_tractions(const RingTrace& trace, const loads::Wrench& wanted,
                     const Vector3d& about, Matrix3Xd& tractions,
                     Index instant) {
    const auto missing =
        loads::DiscreteBalance(trace.ring, about).missing(wanted, tractions);
    for (Index c = 0; c < tractions.cols(); ++c) {
      tractions.col(c) += missing.traction(trace.ring.points.col(c));
    }
    const Matrix3Xd in_frame = solid_.axes.transpose() * tractions;
    const Index n = trace.arc.size();
    for (int h = 0; h < kLinearHarmonics; ++h) {
      auto& load = loads_[static_cast<std::size_t>(h)];
      MatrixXd weighted(n, 3);
      for (Index q = 0; q < n; ++q) {
        weighted.row(q) =
            trace.arc[q] *
            project(load.harmonic, in_frame.middleCols<kAngles>(kAngles * q))
                .transpose();
      }
      scatter(trace.trace, weighted, load, instant);
    }
  }

  /// Adds Σ_q N(q) t(q) of a term. @param weighted  points × 3.
  static void scatter(const GroupTrace& trace, const MatrixXd& weighted,
                      HarmonicLoad& load, Index instant) {
    Index begin = 0;
    for (const auto& face : trace.faces) {
      const Index n = face.values->rows();
      const MatrixXd nodal =
          face.values->transpose() * weighted.middleRows(begin, n);
      for (std::size_t k = 0; k < face.nodes.size(); ++k) {
        const auto at = static_cast<Index>(
            std::ranges::lower_bound(load.nodes, face.nodes[k]) -
            load.nodes.begin());
        load.values.col(instant).segment<3>(3 * at) +=
            nodal.row(static_cast<Index>(k)).transpose();
      }
      begin += n;
    }
  }

  const Discretization<2>& meridian_;
  const mesh::Revolution& solid_;
  const loads::LoadHistory& history_;
  const std::string& part_name_;
  Index instants_;
  FaceTables<2> tables_;
  std::vector<HarmonicLoad> loads_;  ///< linear_harmonics first
};

/// ∫ N r, ∫ N x r and ∫ N r² dA per node of the meridian.
MatrixXd node_moments(const Discretization<2>& meridian) {
  const auto rule = gauss<2>(meridian.shape, meridian.degree + 3);
  const auto displacement =
      tabulate_displacement<2>(meridian.shape, meridian.degree, rule.points);
  const CellInterpolation<2> geometry(meridian.shape, meridian.geometry_degree,
                                      rule.points);
  MatrixXd moments = MatrixXd::Zero(meridian.nodes, 3);
  for (std::size_t c = 0; c < meridian.cell_nodes.size(); ++c) {
    const auto at = cell_geometry<2>(meridian.cell_points[c], geometry);
    const Eigen::VectorXd radius = at.points.row(1).transpose();
    MatrixXd factors(radius.size(), 3);
    factors.col(0).setOnes();
    factors.col(1) = at.points.row(0).transpose();
    factors.col(2) = radius;
    const Eigen::VectorXd weights =
        rule.weights.cwiseProduct(at.determinant).cwiseProduct(radius);
    const MatrixXd cell =
        displacement.values.transpose() * (weights.asDiagonal() * factors);
    const auto& nodes = meridian.cell_nodes[c];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      moments.row(nodes[i]) += cell.row(static_cast<Index>(i));
    }
  }
  return moments;
}

/// The six rigid motions about the frame's origin as linear fields: 12 × 6.
MatrixXd rigid_coefficients(double length) {
  MatrixXd coefficients(12, 6);
  for (int k = 0; k < 3; ++k) {
    coefficients.col(k) =
        linear_coefficients(Vector3d::Unit(k), Matrix3d::Zero());
    Matrix3d turn;
    for (int b = 0; b < 3; ++b) {
      turn.col(b) = Vector3d::Unit(k).cross(Vector3d::Unit(b)) / length;
    }
    coefficients.col(3 + k) = linear_coefficients(Vector3d::Zero(), turn);
  }
  return coefficients;
}

}  // namespace

std::vector<HarmonicLoad> assemble_harmonic_loads(
    const Discretization<2>& meridian, const mesh::Revolution& solid,
    const loads::LoadHistory& history, double density, int highest,
    const std::string& part_name) {
  Assembly assembly(meridian, solid, history, part_name, highest);
  for (std::size_t s = 0; s < history.seats.size(); ++s) assembly.add_seat(s);
  for (std::size_t s = 0; s < history.instants.front().surface_loads.size();
       ++s) {
    assembly.add_surface(s);
  }
  assembly.add_body(density, node_moments(meridian));
  return assembly.loaded();
}

MatrixXd harmonic_rigid_modes(const Harmonic& harmonic,
                              const Discretization<2>& meridian,
                              double length) {
  if (harmonic.order > 1) return MatrixXd::Zero(3 * meridian.nodes, 6);
  MatrixXd values(meridian.nodes, 3);
  values << Eigen::VectorXd::Ones(meridian.nodes),
      node_positions(meridian).transpose();
  return linear_columns(harmonic, values) * rigid_coefficients(length) /
         wave_norm(harmonic);
}

std::pair<double, double> balance_harmonic_loads(
    const Discretization<2>& meridian, double density, double length,
    std::vector<HarmonicLoad>& loads) {
  if (loads.empty()) return {0.0, 0.0};
  const Index instants = loads.front().values.cols();
  const MatrixXd moments = density * node_moments(meridian);
  MatrixXd mass = MatrixXd::Zero(6, 6);
  MatrixXd residual = MatrixXd::Zero(6, instants);
  Eigen::RowVectorXd size = Eigen::RowVectorXd::Zero(instants);
  std::vector<std::pair<HarmonicLoad*, MatrixXd>> inertia;
  for (const Harmonic& harmonic : linear_harmonics()) {
    if (harmonic.order > 1) continue;
    const MatrixXd modes = harmonic_rigid_modes(harmonic, meridian, length);
    const MatrixXd forces =
        linear_columns(harmonic, moments) * rigid_coefficients(length);
    mass += modes.transpose() * forces;
    const auto load =
        std::ranges::find(loads, harmonic, &HarmonicLoad::harmonic);
    if (load == loads.end()) continue;
    residual += transposed_product(modes, load->values);
    inertia.emplace_back(&*load, forces);
  }
  for (const auto& load : loads) size += load.values.cwiseAbs().colwise().sum();
  const double scale = size.maxCoeff();
  if (!(scale > 0.0)) return {0.0, 0.0};
  const MatrixXd acceleration = mass.fullPivLu().solve(residual);
  MatrixXd rest = MatrixXd::Zero(6, instants);
  for (auto& [load, forces] : inertia) {
    load->values -= product(forces, acceleration);
    rest += transposed_product(
        harmonic_rigid_modes(load->harmonic, meridian, length), load->values);
  }
  return {residual.cwiseAbs().maxCoeff() / scale,
          rest.cwiseAbs().maxCoeff() / scale};
}

}  // namespace clevis::elasticity
