#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "dynamics/load_vibration/load_path.h"
#include "elasticity/vibration/seat_shapes.h"
#include "loads/history/load_history.h"
#include "loads/holds/spread_seats.h"

namespace clevis::assessment {

/// A vibration of a part as the mechanism holds and weighs it.
struct ExcitedMode {
  double period{};  ///< [s]
  double answer{};  ///< to the loads, over that of the mode with the most [1]
};

/// Modes of a hold, and the first period of those that bend the part, whether
/// loads excite it or not.
struct HeldModes {
  double first_period{};           ///< [s]
  std::vector<ExcitedMode> modes;  ///< that count, the longest first
};

/// Of the modes that count [s]; none: longest 0.
struct CountedPeriods {
  double shortest{}, longest{};
};
CountedPeriods counted_periods(const HeldModes& held);

/// Whether two holds leave the same vibrations to the loads: those that count
/// with one are among those of the other, periods less than a share apart [1].
/// The first one of all says nothing of a link that bends in its plane, if that
/// is across it.
bool are_like(const HeldModes& a, const HeldModes& b, double apart);

/// Instants whose modes are like those of the first of their group: eight
/// groups at most, for which they may be farther apart.
/// @param modes  of each instant. @param at  of these.
std::vector<std::vector<std::size_t>> like_instants(
    const std::vector<HeldModes>& modes, const std::vector<std::size_t>& at);

inline constexpr double kLikePeriods = 0.02;  ///< as the width of a resonance

/// Longest period of the vibrations that strain the part [s]: rigid ones and
/// other bodies swing more slowly on soft springs. None does: the shortest.
/// @param own_share  the part's, of their strain energy [1].
double longest_of_part(const Eigen::VectorXd& periods,
                       const Eigen::VectorXd& own_share);

/// What an instant's seats carry, 6 n [N], [N m].
Eigen::VectorXd seat_wrenches(const loads::InstantLoad& instant);

/// By what the seats' loads of a motion differ from those at its first instant:
/// at so many instants as show it, and where a seat's force or moment differs
/// most, 6 n × columns [N], [N m]. In whatever frame they are the same ones.
Eigen::MatrixXd seat_changes(const loads::LoadHistory& motion);

/// Which vibrations of a part the loads of its motion excite. A mode counts by
/// what its share of the loads would bend the part to at rest, times what an
/// oscillator of its period answers to them.
class ExcitedModes {
 public:
  /// @param motion  of followed_loads(). @param shapes  of `seats`, which
  ///   outlive the object as they do.
  ExcitedModes(const PartJob& job, const LoadSet& motion,
               const loads::SpreadSeats& seats,
               const elasticity::SeatShapes& shapes);

  /// At an instant. The loads of all bend the part as it stands then.
  /// @param hold  of the spread seats.
  HeldModes of(const loads::SeatHold& hold, std::size_t instant);

 private:
  double amplification(double period);

  const loads::SpreadSeats& seats_;
  const elasticity::SeatShapes& shapes_;
  dynamics::LoadPath path_;
  double damping_;
  Eigen::MatrixXd changes_;                     ///< seat_changes()
  bool has_others_;                             ///< loads that are not of seats
  std::map<long long, double> amplifications_;  ///< by the period's logarithm
};

}  // namespace clevis::assessment
