#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "loads/history/load_history.h"
#include "loads/pressure/discrete_balance.h"
#include "loads/pressure/seat_traction.h"
#include "part/bore.h"

namespace clevis::loads {

/// How a pin (or a guide) presses on what there is of a cylinder's wall.
///
/// Where the wall is whole, in rings too, by BearingTraction. Where a keyway, a
/// slot or a cross bore takes some of it, as wall_pressure has it: a rigid pin
/// without play on an even elastic layer, whose pressures on a whole wall are
/// those of BearingTraction. Force along and moment about the axis are uniform
/// shear of the wall that is there.
/// Source: docs/theory.md, "Bearing load".
class PinPressure {
 public:
  /// @param quadrature  of the wall; outlives this.
  /// @param outward     the part's unit normals there.
  PinPressure(const part::Bore& bore, const GroupQuadrature& quadrature,
              const Eigen::Matrix3Xd& outward);

  bool is_whole() const { return is_whole_; }
  /// Tractions on the part [Pa], but for what DiscreteBalance adds; nothing
  /// where the wall would have to pull.
  /// @param wrench  about bore.p_LC, in L.
  std::optional<Eigen::Matrix3Xd> tractions(const Wrench& wrench) const;
  /// Largest pressure of a wrench [Pa]; nothing where the wall would have to
  /// pull.
  std::optional<double> largest_pressure(const Wrench& wrench) const;

 private:
  /// Uniform shear of the wall [Pa].
  Eigen::Matrix3Xd shear(const Wrench& wrench) const;

  part::Bore bore_;
  const GroupQuadrature* quadrature_;
  WallPoints points_;
  bool is_whole_;
  WallMoments moments_;  ///< if whole
};

/// Largest pressure of a pin on a wall that is closed all round [Pa].
/// @param wrench  about bore.p_LC, in L.
/// @param wall    of the bore.
double largest_bearing_pressure(const part::Bore& bore, const Wrench& wrench,
                                const WallMoments& wall);

/// Of a pin that its wall could only hold by pulling.
/// @param place  of the error. @param label  of the instant.
/// @throws Error L002.
[[noreturn]] void refuse_open_wall(const std::string& place,
                                   const std::string& group,
                                   const std::string& label);

}  // namespace clevis::loads
