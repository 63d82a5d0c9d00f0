#include "elasticity/buckling/seat_pushes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/holds/bore_pieces.h"
#include "elasticity/nodal_loads/seat_means.h"
#include "loads/history/motion_instants.h"
#include "loads/holds/spread_seats.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kMotion = 6;
using Wrench6 = Eigen::Matrix<double, kMotion, 1>;

/// sym(Σ fᵢ rᵢᵀ) of nodal forces f [N] at r from a point [N m].
/// @param counts  whether a node does.
template <class Counts>
Matrix3d virial_of(const Eigen::Ref<const VectorXd>& forces,
                   const std::vector<Index>& nodes,
                   const Eigen::Matrix3Xd& positions,
                   const Eigen::Vector3d& point, const Counts& counts) {
  Matrix3d sum = Matrix3d::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!counts(nodes[i])) continue;
    sum += forces.segment<3>(3 * static_cast<Index>(i)) *
           (positions.col(nodes[i]) - point).transpose();
  }
  return 0.5 * (sum + sum.transpose());
}

Matrix3d virial_of(const Eigen::Ref<const VectorXd>& forces,
                   const std::vector<Index>& nodes,
                   const Eigen::Matrix3Xd& positions,
                   const Eigen::Vector3d& point) {
  return virial_of(forces, nodes, positions, point, [](Index) {
    return true;
  });
}

/// A seat's surface.
struct SeatSurface {
  /// Its mean motions, which are nodal forces of unit wrenches as well; of a
  /// slide those of what is touched, at some of its places; of a bore in pieces
  /// those of each behind those of all.
  std::vector<NodeFunctionals<3>> motions;
  std::vector<std::vector<loads::PlaceShare>>
      shares;                     ///< of the places, by instant
  std::vector<Matrix3d> virials;  ///< of its loads, by instant [N m]
  /// Of the loads on each piece about its own centre, by instant; they are not
  /// in the virials of the whole.
  std::vector<std::vector<Matrix3d>> of_pieces = {};
};

/// Virials of a slide: its loads count as they act on the mean motions of what
/// is touched; a guide's pressure on a round wall as through its axis.
std::vector<Matrix3d> virials_of_slide(const SeatSurface& surface,
                                       const Eigen::Matrix3Xd& positions,
                                       const loads::LoadHistory& history,
                                       std::size_t s,
                                       const std::vector<double>& places) {
  const loads::Seat& seat = history.seats[s];
  std::vector<Matrix3d> virials(history.instants.size(), Matrix3d::Zero());
  for (std::size_t i = 0; i < virials.size(); ++i) {
    const loads::Wrench& wrench = history.instants[i].wrenches[s];
    if (seat.kind == loads::SeatKind::kBearing) {
      if (i >= places.size() || !std::isfinite(places[i])) continue;
      const Matrix3d sum =
          wrench.force * (places[i] * seat.slide->along_L).transpose();
      virials[i] = 0.5 * (sum + sum.transpose());
      continue;
    }
    Wrench6 amounts;
    amounts << wrench.force, wrench.moment;
    for (const auto& [place, share] : surface.shares[i]) {
      const auto& motions = surface.motions[place];
      virials[i] += share * virial_of(motions.rows.transpose() * amounts,
                                      motions.nodes, positions, seat.p_LS);
    }
  }
  return virials;
}

/// Of a slide.
SeatSurface touched_surface(const Discretization<3>& discretization,
                            const Eigen::Matrix3Xd& positions,
                            const loads::LoadHistory& history, std::size_t s,
                            const std::string& part_name) {
  const loads::Seat& seat = history.seats[s];
  const SlideWall<3> wall(discretization, seat, part_name);
  const auto motions = [&](const std::vector<loads::ContactZone>& zones) {
    return mean_motions<3>(seat_mean(wall, seat, zones));
  };
  const std::vector<double> places = loads::places_on_wall(history, s);
  SeatSurface surface;
  std::vector<double> known;
  constexpr int kSteps = 8;  // what lies between is linear to 1/64 of its bow
  for (const std::size_t i : loads::spread_places(places, kSteps)) {
    known.push_back(places[i]);
    surface.motions.push_back(motions({history.instants[i].zones[s]}));
  }
  const std::size_t whole = surface.motions.size();
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const bool is_known = i < places.size() && std::isfinite(places[i]);
    if (!is_known && surface.motions.size() == whole) {
      surface.motions.push_back(motions({}));
    }
    surface.shares.push_back(
        is_known ? loads::shares_of(places[i], known)
                 : std::vector<loads::PlaceShare>{{whole, 1.0}});
  }
  surface.virials = virials_of_slide(surface, positions, history, s, places);
  return surface;
}

SeatSurface surface_of(const Discretization<3>& discretization,
                       const Eigen::Matrix3Xd& positions,
                       const loads::LoadHistory& history, std::size_t s,
                       const SurfaceLoads& loads,
                       const std::string& part_name) {
  const loads::Seat& seat = history.seats[s];
  if (seat.slide) {
    return touched_surface(discretization, positions, history, s, part_name);
  }
  SeatSurface surface;
  surface.motions.push_back(
      mean_motions<3>(seat_mean(discretization, seat, {}, part_name)));
  surface.shares.assign(history.instants.size(), {{0, 1.0}});
  const std::vector<Index> nodes(loads.nodes.begin(), loads.nodes.end());
  for (Index i = 0; i < loads.values.cols(); ++i) {
    surface.virials.push_back(
        virial_of(loads.values.col(i), nodes, positions, seat.p_LS));
  }
  if (seat.kind != loads::SeatKind::kBearing) return surface;
  // Ears of a fork tilt each by itself: all together they hardly turn.
  const NodeFunctionals<3> whole = surface.motions.front();
  for (BorePiece& piece :
       bore_pieces(discretization, seat.group, whole, positions)) {
    auto& virials = surface.of_pieces.emplace_back();
    for (Index i = 0; i < loads.values.cols(); ++i) {
      const auto of = [&](const Eigen::Vector3d& point) {
        return virial_of(
            loads.values.col(i), nodes, positions, point, [&piece](Index node) {
              return piece.has_node[static_cast<std::size_t>(node)];
            });
      };
      virials.push_back(of(piece.centre));
      surface.virials[static_cast<std::size_t>(i)] -= virials.back();
    }
    surface.motions.push_back(std::move(piece.motions));
  }
  return surface;
}

/// Moment that nodal forces gain as they keep their direction on a surface that
/// turns, which their stresses have in K_G [N m]. What is pressed by a pin, or
/// welded, turns in its neighbour: its force goes through the seat's point.
Matrix3d gain_of_dead(const Matrix3d& virial) {
  return virial - virial.trace() * Matrix3d::Identity();
}

/// Gains of an instant; of a case none, on the seats that pins press.
loads::SeatGains gains_of(const loads::LoadHistory& history,
                          const loads::InstantLoad& instant) {
  if (instant.gains) return instant.gains();
  loads::SeatGains none;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    const loads::Seat& seat = history.seats[s];
    if (seat.kind == loads::SeatKind::kBearing && !seat.slide) {
      none.seats.push_back(s);
    }
  }
  const Index motions = kMotion * std::ssize(none.seats);
  none.gain = MatrixXd::Zero(motions, motions);
  return none;
}

}  // namespace

SeatPushes::SeatPushes(const Discretization<3>& discretization,
                       const loads::LoadHistory& history,
                       const std::vector<SurfaceLoads>& of_surfaces,
                       const std::string& part_name)
    : dofs_(discretization.dofs()) {
  constexpr double kNothing = 1e-9;  // of the forces
  std::map<std::size_t, SeatSurface> surfaces;
  // First motions of the history's seats, at their places.
  std::map<std::pair<std::size_t, std::size_t>, Index> known;
  const auto positions = node_positions(discretization);
  const double size =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  const auto surface = [&](std::size_t s) -> const SeatSurface& {
    const auto found = surfaces.find(s);
    if (found != surfaces.end()) return found->second;
    return surfaces
        .emplace(s, surface_of(discretization, positions, history, s,
                               of_surfaces[s], part_name))
        .first->second;
  };
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const loads::InstantLoad& instant = history.instants[i];
    Push& push = of_instant_.emplace_back();
    const loads::SeatGains found = gains_of(history, instant);
    if (found.seats.empty()) continue;
    MatrixXd dead = MatrixXd::Zero(found.gain.rows(), found.gain.cols());
    VectorXd scale = VectorXd::Ones(found.gain.rows());  // of turns to lengths
    double forces = 0.0;
    for (std::size_t k = 0; k < found.seats.size(); ++k) {
      const loads::Seat& seat = history.seats[found.seats[k]];
      const loads::Wrench& wrench = instant.wrenches[found.seats[k]];
      const Index turn = kMotion * static_cast<Index>(k) + 3;
      scale.segment<3>(turn).setConstant(1.0 / size);
      forces += wrench.force.norm() + wrench.moment.norm() / size;
      if (has_faces(discretization, seat.group)) {
        dead.block<3, 3>(turn, turn) =
            gain_of_dead(surface(found.seats[k]).virials[i]);
      }
    }
    const MatrixXd gain = found.gain - dead;
    std::vector<std::pair<Index, Matrix3d>> of_pieces;  // of their turns
    std::vector<Index> kept;     // rows of the gain, by motion
    std::vector<double> shares;  // of a seat's motion, likewise
    for (std::size_t k = 0; k < found.seats.size(); ++k) {
      const Index at = kMotion * static_cast<Index>(k);
      if (!has_faces(discretization, history.seats[found.seats[k]].group)) {
        continue;
      }
      const SeatSurface& here = surface(found.seats[k]);
      const auto motion_at = [&](std::size_t place) {
        const auto [first, is_new] = known.try_emplace(
            {found.seats[k], place}, kMotion * std::ssize(seats_));
        if (is_new) seats_.push_back(here.motions[place]);
        return first->second;
      };
      for (std::size_t p = 0; p < here.of_pieces.size(); ++p) {
        const Matrix3d of_piece = -gain_of_dead(here.of_pieces[p][i]);
        if (of_piece.norm() <= kNothing * forces * size) continue;
        of_pieces.emplace_back(motion_at(1 + p) + 3, of_piece);
      }
      if ((scale.segment<kMotion>(at).asDiagonal() *
           gain.middleRows<kMotion>(at) * scale.asDiagonal())
                  .norm() *
              size <=
          kNothing * forces) {
        continue;
      }
      for (const auto& [place, share] : here.shares[i]) {
        const Index first = motion_at(place);
        for (Index motion = 0; motion < kMotion; ++motion) {
          kept.push_back(at + motion);
          shares.push_back(share);
          push.motions.push_back(first + motion);
        }
      }
    }
    const Eigen::Map<const VectorXd> by(shares.data(), std::ssize(shares));
    const Index of_seats = std::ssize(kept);
    const Index all = of_seats + 3 * std::ssize(of_pieces);
    push.gain = MatrixXd::Zero(all, all);
    push.gain.topLeftCorner(of_seats, of_seats) =
        by.asDiagonal() * gain(kept, kept) * by.asDiagonal();
    for (const auto& [turn, of_piece] : of_pieces) {
      const Index row = std::ssize(push.motions);
      push.gain.block<3, 3>(row, row) = of_piece;
      for (Index d = 0; d < 3; ++d) push.motions.push_back(turn + d);
    }
  }
}

MatrixXd SeatPushes::gain(Index instant) const {
  const Index all = kMotion * std::ssize(seats_);
  MatrixXd gain = MatrixXd::Zero(all, all);
  const Push& push = of_instant_[static_cast<std::size_t>(instant)];
  gain(push.motions, push.motions) = push.gain;
  return gain;
}

void SeatPushes::add(const MatrixXd& u, const MatrixXd& gain,
                     MatrixXd& forces) const {
  if (is_empty()) return;
  add_forces(gain * motions(u), forces);
}

void SeatPushes::add_forces(const MatrixXd& pushing, MatrixXd& forces) const {
  for (std::size_t k = 0; k < seats_.size(); ++k) {
    seats_[k].add(pushing.middleRows<kMotion>(kMotion * static_cast<Index>(k)),
                  forces);
  }
}

MatrixXd SeatPushes::unit_forces() const {
  const Index motions = kMotion * std::ssize(seats_);
  MatrixXd forces = MatrixXd::Zero(dofs_, motions);
  add_forces(MatrixXd::Identity(motions, motions), forces);
  return forces;
}

MatrixXd SeatPushes::motions(const MatrixXd& u) const {
  MatrixXd motions(kMotion * std::ssize(seats_), u.cols());
  for (std::size_t k = 0; k < seats_.size(); ++k) {
    motions.middleRows<kMotion>(kMotion * static_cast<Index>(k)) =
        seats_[k].of(u);
  }
  return motions;
}

}  // namespace clevis::elasticity
