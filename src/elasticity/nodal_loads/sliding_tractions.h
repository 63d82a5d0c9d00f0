#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "loads/history/load_history.h"
#include "loads/pressure/discrete_balance.h"
#include "loads/pressure/load_scale.h"
#include "loads/pressure/seat_traction.h"
#include "part/bore.h"

namespace clevis::elasticity {

/// Tractions of a seat on which the counterpart slides: bearing pressure on
/// the length of a cylinder that it touches, pressure of a rigid counterpart
/// on walls (loads::wall_pressure); shear for the rest of the wrench.
class SlidingTractions {
 public:
  /// @param cylinder  of the seat's group, if it has one.
  /// @throws Error L002 if it bears on a group that is no cylinder.
  SlidingTractions(const loads::LoadHistory& history, std::size_t seat,
                   const std::optional<part::Bore>& cylinder,
                   const std::string& part_name);

  loads::ContactZone zone(std::size_t instant) const;

  /// On the length of the cylinder that is touched. @pre it is a cylinder.
  loads::BearingTraction bearing(std::size_t instant) const;

  /// @param quadrature  of what of the zone the mesh has.
  /// @return [Pa], whose discrete resultant is the wrench.
  /// @throws Error L007 if flat walls would have to pull, or the mesh has
  ///   nothing there; L002 if a cylinder would.
  Eigen::Matrix3Xd at(std::size_t instant,
                      const loads::GroupQuadrature& quadrature,
                      const Eigen::Matrix3Xd& outward) const;

 private:
  const loads::LoadHistory& history_;
  std::size_t seat_index_;
  const loads::Seat& seat_;
  std::optional<part::Bore> cylinder_;
  std::string part_name_;
  loads::LoadScale scale_;
};

/// Part of a cylinder that a zone covers.
part::Bore touched(const part::Bore& cylinder, const loads::Seat& seat,
                   const loads::ContactZone& zone);

}  // namespace clevis::elasticity
