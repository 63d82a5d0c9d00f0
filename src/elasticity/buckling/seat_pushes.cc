#include "elasticity/buckling/seat_pushes.h"

#include <array>
#include <map>
#include <utility>

#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/seat_means.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kMotion = 6;
using Wrench6 = Eigen::Matrix<double, kMotion, 1>;

/// A seat's surface: its mean motions, which are nodal forces of unit wrenches
/// as well.
struct SeatSurface {
  NodeFunctionals motions;
  /// sym(Σ fᵢ rᵢᵀ) of the nodal forces of each unit wrench [m], [1].
  std::array<Matrix3d, kMotion> virials;
};

SeatSurface surface_of(const Discretization<3>& discretization,
                       const Eigen::Matrix3Xd& positions,
                       const loads::Seat& seat, const std::string& part_name) {
  SeatSurface surface{
      nodes_of(seat_means(discretization, {seat}, {}, part_name)), {}};
  const NodeFunctionals& of = surface.motions;
  for (Index k = 0; k < kMotion; ++k) {
    Matrix3d sum = Matrix3d::Zero();
    for (Index i = 0; i < std::ssize(of.nodes); ++i) {
      const Index node = of.nodes[static_cast<std::size_t>(i)];
      sum += of.rows.row(k).segment<3>(3 * i).transpose() *
             (positions.col(node) - seat.p_LS).transpose();
    }
    surface.virials[static_cast<std::size_t>(k)] =
        0.5 * (sum + sum.transpose());
  }
  return surface;
}

/// Moment that nodal forces of a wrench gain as they keep their direction on a
/// surface that turns, which their stresses have in K_G [N m].
Matrix3d gain_of_dead(const SeatSurface& surface, const loads::Wrench& wrench) {
  Wrench6 amounts;
  amounts << wrench.force, wrench.moment;
  Matrix3d virial = Matrix3d::Zero();
  for (Index k = 0; k < kMotion; ++k) {
    virial += amounts[k] * surface.virials[static_cast<std::size_t>(k)];
  }
  return virial - virial.trace() * Matrix3d::Identity();
}

}  // namespace

SeatPushes::SeatPushes(const Discretization<3>& discretization,
                       const loads::LoadHistory& history,
                       const std::string& part_name) {
  constexpr double kNothing = 1e-9;  // of the forces
  std::map<std::size_t, SeatSurface> surfaces;
  std::map<std::size_t, Index> known;  // first motions of the history's seats
  const auto positions = node_positions(discretization);
  const double size =
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  const auto surface = [&](std::size_t s) -> const SeatSurface& {
    const auto found = surfaces.find(s);
    if (found != surfaces.end()) return found->second;
    return surfaces
        .emplace(s, surface_of(discretization, positions, history.seats[s],
                               part_name))
        .first->second;
  };
  for (const loads::InstantLoad& instant : history.instants) {
    Push& push = of_instant_.emplace_back();
    if (!instant.gains) continue;
    const loads::SeatGains found = instant.gains();
    MatrixXd dead = MatrixXd::Zero(found.gain.rows(), found.gain.cols());
    VectorXd scale = VectorXd::Ones(found.gain.rows());  // of turns to lengths
    double forces = 0.0;
    for (std::size_t k = 0; k < found.seats.size(); ++k) {
      const loads::Seat& seat = history.seats[found.seats[k]];
      const loads::Wrench& wrench = instant.wrenches[found.seats[k]];
      const Index turn = kMotion * static_cast<Index>(k) + 3;
      scale.segment<3>(turn).setConstant(1.0 / size);
      forces += wrench.force.norm() + wrench.moment.norm() / size;
      // A pin's force goes through its axis, where no turn moves it.
      if (seat.kind != loads::SeatKind::kBearing &&
          has_faces(discretization, seat.group)) {
        dead.block<3, 3>(turn, turn) =
            gain_of_dead(surface(found.seats[k]), wrench);
      }
    }
    const MatrixXd gain =
        found.gain - found.admitted.transpose() * dead * found.admitted;
    std::vector<Index> kept;
    for (std::size_t k = 0; k < found.seats.size(); ++k) {
      const Index at = kMotion * static_cast<Index>(k);
      if (!has_faces(discretization, history.seats[found.seats[k]].group) ||
          (scale.segment<kMotion>(at).asDiagonal() *
           gain.middleRows<kMotion>(at) * scale.asDiagonal())
                      .norm() *
                  size <=
              kNothing * forces) {
        continue;
      }
      const auto [first, is_new] =
          known.try_emplace(found.seats[k], kMotion * std::ssize(seats_));
      if (is_new) seats_.push_back(surface(found.seats[k]).motions);
      for (Index i = 0; i < kMotion; ++i) {
        kept.push_back(at + i);
        push.motions.push_back(first->second + i);
      }
    }
    push.gain = gain(kept, kept);
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
  const MatrixXd pushing = gain * motions(u);
  for (std::size_t k = 0; k < seats_.size(); ++k) {
    seats_[k].add(pushing.middleRows<kMotion>(kMotion * static_cast<Index>(k)),
                  forces);
  }
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
