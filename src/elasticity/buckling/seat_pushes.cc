#include "elasticity/buckling/seat_pushes.h"

#include <map>

#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/seat_means.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;

SeatPushes::SeatPushes(const Discretization<3>& discretization,
                       const loads::LoadHistory& history,
                       const std::string& part_name) {
  std::map<std::size_t, std::size_t> known;  // of the history's seats
  for (const loads::InstantLoad& instant : history.instants) {
    auto& pushes = of_instant_.emplace_back();
    for (const loads::FollowingForce& force : instant.following) {
      const loads::Seat& seat = history.seats[force.seat];
      if (!has_faces(discretization, seat.group)) continue;
      const auto [index, is_new] = known.try_emplace(force.seat, seats_.size());
      if (is_new) {
        seats_.push_back(nodes_of(
            seat_means(discretization, {seat}, {}, part_name).leftCols<3>()));
      }
      pushes.push_back({index->second, force.gain});
    }
  }
}

void SeatPushes::add(const MatrixXd& u, Index instant, MatrixXd& forces) const {
  if (is_empty()) return;
  for (const Push& push : of_instant_[static_cast<std::size_t>(instant)]) {
    const NodeFunctionals& seat = seats_[push.seat];
    seat.add(push.gain * seat.of(u), forces);
  }
}

MatrixXd SeatPushes::means(const MatrixXd& u) const {
  MatrixXd means(3 * std::ssize(seats_), u.cols());
  for (std::size_t k = 0; k < seats_.size(); ++k) {
    means.middleRows<3>(3 * static_cast<Index>(k)) = seats_[k].of(u);
  }
  return means;
}

void SeatPushes::add_form(const MatrixXd& means, Index instant,
                          MatrixXd& form) const {
  if (is_empty()) return;
  for (const Push& push : of_instant_[static_cast<std::size_t>(instant)]) {
    const MatrixXd here =
        means.middleRows<3>(3 * static_cast<Index>(push.seat));
    form += here.transpose() * push.gain * here;
  }
}

}  // namespace clevis::elasticity
