#include "elasticity/vibration/ground_hold.h"

#include <cstddef>
#include <utility>

#include "elasticity/nodal_loads/load_vectors.h"

namespace clevis::elasticity {

template <int dim>
Eigen::MatrixXd ground_hold(const Discretization<dim>& discretization,
                            const loads::LoadHistory& history,
                            const std::string& part_name) {
  constexpr double kInPlane = 0.5;
  loads::LoadHistory unit;
  for (const loads::Seat& seat : history.seats) {
    if (seat.grounded.cols() == 0) continue;
    unit.seats.push_back(seat);
    unit.seats.back().kind = loads::SeatKind::kTraction;
  }
  for (std::size_t s = 0; s < unit.seats.size(); ++s) {
    for (auto wrench : unit.seats[s].grounded.colwise()) {
      Eigen::Matrix<double, 6, 1> acting = wrench;
      if constexpr (dim == 2) {
        acting.segment<3>(2).setZero();
        if (acting.norm() < kInPlane) continue;
      }
      loads::InstantLoad instant;
      instant.wrenches.resize(unit.seats.size());
      instant.wrenches[s] = {acting.head<3>(), acting.tail<3>()};
      unit.instants.push_back(std::move(instant));
    }
  }
  if (unit.instants.empty()) return {discretization.dofs(), 0};
  return assemble_loads(discretization, unit, 0.0, part_name);
}

template Eigen::MatrixXd ground_hold<2>(const Discretization<2>&,
                                        const loads::LoadHistory&,
                                        const std::string&);
template Eigen::MatrixXd ground_hold<3>(const Discretization<3>&,
                                        const loads::LoadHistory&,
                                        const std::string&);

}  // namespace clevis::elasticity
