#include "elasticity/nodal_loads/seat_means.h"

#include <cstddef>
#include <utility>

#include "elasticity/nodal_loads/load_vectors.h"

namespace clevis::elasticity {

namespace {

template <int dim>
loads::LoadHistory unit_wrenches(std::vector<loads::Seat> seats,
                                 const std::vector<loads::ContactZone>& zones) {
  loads::LoadHistory unit;
  unit.seats = std::move(seats);
  for (loads::Seat& seat : unit.seats) seat.kind = loads::SeatKind::kMean;
  for (std::size_t s = 0; s < unit.seats.size(); ++s) {
    for (const Eigen::Index component : kActing<dim>) {
      loads::InstantLoad instant;
      instant.wrenches.resize(unit.seats.size());
      loads::Wrench& wrench = instant.wrenches[s];
      (component < 3 ? wrench.force[component] : wrench.moment[component - 3]) =
          1.0;
      instant.zones = zones;
      unit.instants.push_back(std::move(instant));
    }
  }
  return unit;
}

}  // namespace

template <int dim>
Eigen::MatrixXd seat_means(const Discretization<dim>& discretization,
                           std::vector<loads::Seat> seats,
                           const std::vector<loads::ContactZone>& zones,
                           const std::string& part_name) {
  return assemble_loads(discretization,
                        unit_wrenches<dim>(std::move(seats), zones), 0.0,
                        part_name);
}

template <int dim>
SurfaceLoads seat_mean(const Discretization<dim>& discretization,
                       loads::Seat seat,
                       const std::vector<loads::ContactZone>& zones,
                       const std::string& part_name) {
  return seat_loads(discretization,
                    unit_wrenches<dim>({std::move(seat)}, zones), 0, part_name);
}

template <int dim>
SurfaceLoads seat_mean(const SlideWall<dim>& wall, loads::Seat seat,
                       const std::vector<loads::ContactZone>& zones) {
  return wall.of(unit_wrenches<dim>({std::move(seat)}, zones), 0);
}

template Eigen::MatrixXd seat_means<2>(const Discretization<2>&,
                                       std::vector<loads::Seat>,
                                       const std::vector<loads::ContactZone>&,
                                       const std::string&);
template Eigen::MatrixXd seat_means<3>(const Discretization<3>&,
                                       std::vector<loads::Seat>,
                                       const std::vector<loads::ContactZone>&,
                                       const std::string&);
template SurfaceLoads seat_mean<2>(const Discretization<2>&, loads::Seat,
                                   const std::vector<loads::ContactZone>&,
                                   const std::string&);
template SurfaceLoads seat_mean<3>(const Discretization<3>&, loads::Seat,
                                   const std::vector<loads::ContactZone>&,
                                   const std::string&);

template SurfaceLoads seat_mean<2>(const SlideWall<2>&, loads::Seat,
                                   const std::vector<loads::ContactZone>&);
template SurfaceLoads seat_mean<3>(const SlideWall<3>&, loads::Seat,
                                   const std::vector<loads::ContactZone>&);

}  // namespace clevis::elasticity
