#include "elasticity/nodal_loads/surface_loads.h"

#include <algorithm>
#include <optional>
#include <utility>

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

/// ∫ N t dA over a group of the tractions of one instant after another. Some
/// instants at a time: at the points of a bore those of all take gigabytes.
template <int dim>
class TractionIntegral {
 public:
  /// @param trace  outlives the object.
  TractionIntegral(const GroupTrace& trace, std::size_t instants)
      : trace_(trace), nodes_(nodes_of(trace)) {
    for (const auto& face : trace.faces) {
      for (const int node : face.nodes) {
        places_.push_back(std::ranges::lower_bound(nodes_, node) -
                          nodes_.begin());
      }
    }
    const auto count = static_cast<Index>(instants);
    values_.resize(dim * std::ssize(nodes_), count);
    block_.resize(trace.quadrature.weights.size(),
                  dim * std::min(kBlock, count));
  }

  /// @param tractions  at the points [Pa].
  void add(const Matrix3Xd& tractions) {
    block_.template middleCols<dim>(dim * in_block_++) =
        tractions.topRows<dim>().transpose();
    if (dim * in_block_ == block_.cols()) flush();
  }

  /// @pre all instants are added.
  SurfaceLoads take() {
    flush();
    return {std::move(nodes_), std::move(values_)};
  }

 private:
  static constexpr Index kBlock = 128;

  static std::vector<int> nodes_of(const GroupTrace& trace) {
    std::vector<int> nodes;
    for (const auto& face : trace.faces) {
      nodes.insert(nodes.end(), face.nodes.begin(), face.nodes.end());
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  void flush() {
    if (in_block_ == 0) return;
    const Index columns = dim * in_block_;
    // A column per node: faces add to it in one stretch.
    MatrixXd sums = MatrixXd::Zero(columns, std::ssize(nodes_));
    Index begin = 0;
    auto place = places_.begin();
    for (const auto& face : trace_.faces) {
      const Index n = face.values->rows();
      const MatrixXd weighted =
          trace_.quadrature.weights.segment(begin, n).asDiagonal() *
          block_.block(begin, 0, n, columns);
      const MatrixXd nodal = transposed_product(weighted, *face.values);
      for (Index k = 0; k < nodal.cols(); ++k) {
        sums.col(*place++) += nodal.col(k);
      }
      begin += n;
    }
    for (Index i = 0; i < in_block_; ++i) {
      values_.col(done_ + i) =
          sums.template middleRows<dim>(dim * i).reshaped();
    }
    done_ += in_block_;
    in_block_ = 0;
  }

  const GroupTrace& trace_;
  std::vector<int> nodes_;
  std::vector<Index> places_;  ///< of the faces' nodes, face after face
  MatrixXd values_;            ///< of SurfaceLoads
  MatrixXd block_;             ///< points × (dim × instants of a block) [Pa]
  Index in_block_{}, done_{};
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
  TractionIntegral<dim> integral(trace, history.instants.size());
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
    integral.add(tractions);
  }
  return integral.take();
}

template <int dim>
SurfaceLoads face_loads(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, std::size_t index,
                        const std::string& part_name, FaceTables<dim>& tables) {
  const auto& name = history.instants.front().surface_loads[index].group;
  const GroupTrace trace = group_trace(
      discretization, find_group(discretization, name, part_name), tables);
  TractionIntegral<dim> integral(trace, history.instants.size());
  const loads::DiscreteBalance balance(trace.quadrature, Vector3d::Zero());
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const loads::SurfaceLoad& load = history.instants[i].surface_loads[index];
    Matrix3Xd tractions = -load.pressure * trace.outward;
    tractions.colwise() += load.traction;
    balance.correct(load.resultant, tractions);
    integral.add(tractions);
  }
  return integral.take();
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
    TractionIntegral<dim> here(trace, 1);
    here.add(tractions.at(i, trace.quadrature, trace.outward));
    const SurfaceLoads part = here.take();
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
