#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Share of its lowest frequency below which a part's spin bends nothing on.
inline constexpr double kSlowSpin = 0.1;

/// Instants of a load set that second order may count for, the motion's before
/// the cases'.
struct SecondOrderLoads {
  std::size_t set{};
  std::vector<loads::InstantLoad> instants;
  std::vector<std::size_t> index;  ///< of each in the set
  std::size_t motion{};            ///< how many of them are the motion's
  /// Share of what buckles the part that the set has, 1/λ with its vibration;
  /// 0: first order is enough [1].
  double pressed{};
  bool may_be_fast{};  ///< its spin, beside the lowest frequency
};
SecondOrderLoads second_order_loads(const PartJob& job, std::size_t set,
                                    const PartResult& result);

/// Loads of an instant, or between two.
struct LoadPoint {
  std::string label;
  double time{};
  bool is_motion{};
  bool goes_on{};           ///< to the next on a straight line
  Eigen::Vector3d omega;    ///< in L [rad/s]
  Eigen::VectorXd amounts;  ///< of load columns
  Eigen::Index instant{};   ///< of the loads; between two the first
  Eigen::MatrixXd gain;     ///< SeatPushes::gain()

  /// Whether loads and spin are nearly the same.
  /// @param share  of each that they may be apart [1].
  bool is_like(const LoadPoint& other, double share) const;
};
/// Of the instants; those of the motion that lie on the straight line between
/// others, but for a third of a per cent, are left out.
/// @param coefficients  columns × instants. @param gain  of an instant.
/// @param stays  whether an instant is never left out.
std::vector<LoadPoint> load_points(
    const SecondOrderLoads& loads, const Eigen::MatrixXd& coefficients,
    const std::function<Eigen::MatrixXd(Eigen::Index)>& gain,
    const std::function<bool(const loads::InstantLoad&)>& stays);
/// On the straight line from one instant to the next.
/// @param share  of the way [1].
LoadPoint between(const LoadPoint& from, const LoadPoint& to, double share);

/// What the loads of a motion that turns on at one speed have in common in the
/// part's frame, where those that stand still in space turn: least squares of
/// c0 + c1 cos θ + c2 sin θ. Nothing of other motions: there each instant's
/// loads move on with what they displace.
/// @param coefficients  amounts of load columns, columns × instants [1].
std::optional<Eigen::VectorXd> common_load(const SecondOrderLoads& loads,
                                           const Eigen::MatrixXd& coefficients);

/// By instant, whether a pin of groups that hold, no guide, takes a moment
/// across its axis. That grows as the part gives way, by no more than the
/// deflection; a solution that spreads what it grows by over the bore does not
/// see that pressure at its ends stresses more.
/// @param holders  loads::holder_of(). @param size  of the part [m].
std::vector<bool> bent_by_pins(const std::vector<loads::Seat>& seats,
                               const SecondOrderLoads& loads,
                               const std::vector<std::string>& holders,
                               double size);

/// Of a load set's motion.
Swing swing_of(const PartResult& result, std::size_t set);

}  // namespace clevis::assessment
