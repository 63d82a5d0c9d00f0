#include "elasticity/nodal_loads/surface_loads.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/messages/errors.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/nodal_loads/sliding_tractions.h"
#include "loads/pressure/discrete_balance.h"
#include "loads/pressure/face_pressure.h"
#include "loads/pressure/load_scale.h"
#include "loads/pressure/pin_pressure.h"

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
              fmt::format("Groups of the mesh: {}.", fmt::join(names, ", ")));
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

  /// ∫ N t dA of every instant.
  SurfaceLoads integrate(const GroupTrace& trace) const {
    SurfaceLoads result;
    for (const auto& face : trace.faces) {
      result.nodes.insert(result.nodes.end(), face.nodes.begin(),
                          face.nodes.end());
    }
    std::ranges::sort(result.nodes);
    result.nodes.erase(std::unique(result.nodes.begin(), result.nodes.end()),
                       result.nodes.end());
    const Index instants = values_.cols() / dim;
    result.values =
        MatrixXd::Zero(dim * static_cast<Index>(result.nodes.size()), instants);
    Index begin = 0;
    for (const auto& face : trace.faces) {
      const Index n = face.values->rows();
      const MatrixXd weighted =
          trace.quadrature.weights.segment(begin, n).asDiagonal() *
          values_.middleRows(begin, n);
      const MatrixXd nodal = transposed_product(*face.values, weighted);
      std::vector<Index> rows;
      for (const int node : face.nodes) {
        rows.push_back(dim * (std::ranges::lower_bound(result.nodes, node) -
                              result.nodes.begin()));
      }
      for (Index i = 0; i < instants; ++i) {
        double* const to = result.values.col(i).data();
        for (Index a = 0; a < dim; ++a) {
          const double* const from = nodal.col(dim * i + a).data();
          for (std::size_t k = 0; k < rows.size(); ++k) {
            to[rows[k] + a] += from[k];
          }
        }
      }
      begin += n;
    }
    return result;
  }

 private:
  MatrixXd values_;
};

template <int dim>
SurfaceLoads loads_of_seat(const Discretization<dim>& discretization,
                           const loads::LoadHistory& history,
                           std::size_t seat_index, const std::string& part_name,
                           FaceTables<dim>& tables) {
  const loads::Seat& seat = history.seats[seat_index];
  if (seat.slide) {
    return SlideWall<dim>(discretization, seat, part_name)
        .of(history, seat_index);
  }
  const int group = find_group(discretization, seat.group, part_name);
  const auto& cylinder =
      discretization.groups[static_cast<std::size_t>(group)].cylinder;
  if (seat.kind == loads::SeatKind::kBearing && !cylinder) {
    throw Error("L002", "part " + part_name + ", group " + seat.group,
                "a pin bears on this group, but it is no circular cylinder",
                "Name the group bore_* or round_* if it is round.");
  }
  const GroupTrace trace = group_trace(discretization, group, tables);
  const auto n = trace.quadrature.weights.size();
  TractionHistory<dim> history_here(n, history.instants.size());
  std::optional<loads::PinPressure> pin;
  if (seat.kind == loads::SeatKind::kBearing) {
    pin.emplace(*cylinder, trace.quadrature, trace.outward);
  }
  const loads::LoadScale scale(history, seat_index);
  const loads::DiscreteBalance balance(trace.quadrature, seat.p_LS);
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const loads::Wrench& wrench = history.instants[i].wrenches[seat_index];
    Matrix3Xd tractions = Matrix3Xd::Zero(3, n);
    if (pin) {
      if (const auto pressed = pin->tractions(wrench)) {
        tractions = *pressed;
      } else if (!scale.is_negligible(wrench)) {
        loads::refuse_open_wall("part " + part_name + ", " + seat.name,
                                seat.group, history.instants[i].label);
      }
    } else if (seat.kind == loads::SeatKind::kPressure) {
      tractions =
          loads::face_pressure(trace.quadrature, trace.outward, wrench.force);
    }
    balance.correct(wrench, tractions);
    history_here.set(i, tractions);
  }
  return history_here.integrate(trace);
}

template <int dim>
SurfaceLoads face_loads(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, std::size_t index,
                        const std::string& part_name, FaceTables<dim>& tables) {
  const auto& name = history.instants.front().surface_loads[index].group;
  const GroupTrace trace = group_trace(
      discretization, find_group(discretization, name, part_name), tables);
  TractionHistory<dim> history_here(trace.quadrature.weights.size(),
                                    history.instants.size());
  const loads::DiscreteBalance balance(trace.quadrature, Vector3d::Zero());
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const loads::SurfaceLoad& load = history.instants[i].surface_loads[index];
    Matrix3Xd tractions = -load.pressure * trace.outward;
    tractions.colwise() += load.traction;
    balance.correct(load.resultant, tractions);
    history_here.set(i, tractions);
  }
  return history_here.integrate(trace);
}

}  // namespace

template <int dim>
SlideWall<dim>::SlideWall(const Discretization<dim>& discretization,
                          const loads::Seat& seat, const std::string& part_name)
    : part_name_(part_name), tables_(std::make_unique<FaceTables<dim>>()) {
  groups_ = {find_group(discretization, seat.group, part_name)};
  if (!seat.slide->opposite.empty()) {
    groups_.push_back(
        find_group(discretization, seat.slide->opposite, part_name));
  }
  for (const int group : groups_) {
    const auto nodes = group_nodes(discretization, group);
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  }
  std::ranges::sort(nodes_);
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  faces_ = std::make_unique<WallFaces<dim>>(discretization, groups_, *tables_);
}

template <int dim>
SurfaceLoads SlideWall<dim>::of(const loads::LoadHistory& history,
                                std::size_t seat_index) const {
  const loads::Seat& seat = history.seats[seat_index];
  const auto instants = history.instants.size();
  SurfaceLoads result{nodes_,
                      MatrixXd::Zero(dim * static_cast<Index>(nodes_.size()),
                                     static_cast<Index>(instants))};
  const SlidingTractions tractions(
      history, seat_index,
      faces_->discretization->groups[static_cast<std::size_t>(groups_.front())]
          .cylinder,
      part_name_);
  std::optional<ZoneTrace<dim>> zone;
  loads::ContactZone touched;
  for (std::size_t i = 0; i < instants; ++i) {
    const loads::ContactZone now = tractions.zone(i);
    if (!zone || (now.low != touched.low).any() ||
        (now.high != touched.high).any()) {
      zone.emplace(*faces_, bounds_of(seat, now));
      touched = now;
    }
    const GroupTrace& trace = zone->trace();
    TractionHistory<dim> here(trace.quadrature.weights.size(), 1);
    here.set(0, tractions.at(i, trace.quadrature, trace.outward));
    const SurfaceLoads part = here.integrate(trace);
    for (std::size_t k = 0; k < part.nodes.size(); ++k) {
      const Index at =
          std::ranges::lower_bound(nodes_, part.nodes[k]) - nodes_.begin();
      result.values.col(static_cast<Index>(i)).template segment<dim>(dim * at) =
          part.values.col(0).template segment<dim>(dim * static_cast<Index>(k));
    }
  }
  return result;
}

template <int dim>
SurfaceLoads seat_loads(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, std::size_t seat,
                        const std::string& part_name) {
  FaceTables<dim> tables;
  return loads_of_seat(discretization, history, seat, part_name, tables);
}

template <int dim>
std::vector<SurfaceLoads> surface_loads(
    const Discretization<dim>& discretization,
    const loads::LoadHistory& history, const std::string& part_name) {
  std::vector<SurfaceLoads> result;
  FaceTables<dim> tables;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    result.push_back(
        loads_of_seat(discretization, history, s, part_name, tables));
  }
  const auto faces = history.instants.front().surface_loads.size();
  for (std::size_t s = 0; s < faces; ++s) {
    result.push_back(face_loads(discretization, history, s, part_name, tables));
  }
  return result;
}

template class SlideWall<2>;
template class SlideWall<3>;
template SurfaceLoads seat_loads<2>(const Discretization<2>&,
                                    const loads::LoadHistory&, std::size_t,
                                    const std::string&);
template SurfaceLoads seat_loads<3>(const Discretization<3>&,
                                    const loads::LoadHistory&, std::size_t,
                                    const std::string&);
template std::vector<SurfaceLoads> surface_loads<2>(const Discretization<2>&,
                                                    const loads::LoadHistory&,
                                                    const std::string&);
template std::vector<SurfaceLoads> surface_loads<3>(const Discretization<3>&,
                                                    const loads::LoadHistory&,
                                                    const std::string&);

}  // namespace clevis::elasticity
