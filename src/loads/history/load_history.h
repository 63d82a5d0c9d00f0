#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/history/contact_zone.h"
#include "part/part_definition.h"

namespace clevis::loads {

/// Model by which a seat takes its wrench.
enum class SeatKind {
  kBearing,   ///< BearingTraction: cylinder pressed by a pin (bore) or by its
              ///< guide (piston)
  kTraction,  ///< LinearTraction: welded face
  kPressure,  ///< face under a drive's effort or a force: an even pressure for
              ///< what acts along its mean normal, LinearTraction for the rest
  kMean,      ///< the same on walls of slides, too: pulls as it presses
};

/// A group of the part's surface where the mechanism acts.
struct Seat {
  std::string name;   ///< joint, drive or case entry
  std::string group;  ///< physical group
  SeatKind kind{};
  /// Reference point: middle of the cylinder's axis, or the area's centroid.
  Eigen::Vector3d p_LS = Eigen::Vector3d::Zero();  ///< [m]
  /// Of a slide whose counterpart does not touch the whole group.
  std::optional<SlideWall> slide = std::nullopt;
};

/// Force and moment on the part, in L; the moment about the seat's p_LS.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [N m]
};

/// Load per area on a whole group, whatever its shape: −pressure n + traction.
struct SurfaceLoad {
  std::string group;
  double pressure{};  ///< > 0 pushes on the face [Pa]
  Eigen::Vector3d traction = Eigen::Vector3d::Zero();  ///< uniform, in L [Pa]
  Wrench resultant;  ///< of both over the exact face; moment about Lo
  double total{};    ///< (|pressure| + |traction|) times the area [N]
};

/// Rigid motion of the part that its material feels, in L. The body force at
/// a point Q is −ρ (acceleration + α×p_LQ + ω×(ω×p_LQ)).
struct RigidAcceleration {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< of Lo, minus
                                                           ///< gravity [m/s²]
  Eigen::Vector3d alpha = Eigen::Vector3d::Zero();         ///< [rad/s²]
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();         ///< [rad/s]
};

/// What forces and moments on seats gain as the seats move, because loads of
/// the mechanism follow: a link that presses pushes on across, a load on a mast
/// has an arm. Motions and gains are six numbers a seat, in L: of its point,
/// then turns, [m], [rad].
struct SeatGains {
  std::vector<std::size_t> seats;
  Eigen::MatrixXd gain;  ///< symmetric [N/m], [N], [N m]
};

/// All loads of a part at an instant (or in a case); in balance unless fixed.
struct InstantLoad {
  std::string label;             ///< "t = 0.31 s" or the case's name
  double time{};                 ///< [s]; 0 for a case
  std::vector<Wrench> wrenches;  ///< one per seat
  /// One per seat; empty where all seats take their load on the whole group.
  std::vector<ContactZone> zones = {};
  /// The same groups in the same order at every instant of a history.
  std::vector<SurfaceLoad> surface_loads;
  RigidAcceleration rigid;
  /// Of a motion's instant; empty: loads keep size and direction.
  std::function<SeatGains()> gains = {};
  /// Of a case: what its loads leave, which `rigid` takes up; about Lo.
  Wrench relief = {};
  bool is_between_rows{};  ///< of a file, in none of them
  bool is_case{};          ///< behind the instants of a motion
};

/// Bodies about a part that springs swing by themselves, as of
/// mechanism::SwingingNeighbours: wrenches on the part seat by seat.
struct SwingingBodies {
  Eigen::MatrixXd held, sprung, damped;
  Eigen::MatrixXd followed, sprung_there, damped_there;
};

/// What the rest of the mechanism does to a part that vibrates, at an instant:
/// directions in which it does not give way at the seats, and the masses that
/// it adds. Columns of wrenches, force [1], [√kg] above moment about p_LS [m],
/// [m √kg], seat by seat, in L; w wᵀ is an added mass.
struct SeatHold {
  double time{};  ///< of the instant [s]
  Eigen::MatrixXd held = {};
  Eigen::MatrixXd weighed = {};
  /// Skew: takes speeds of the seats to the wrenches that turning what spins
  /// takes [kg/s], [m kg/s], [m² kg/s]. Empty: nothing spins.
  Eigen::MatrixXd spin = {};
  /// w wᵀ are stiffness and damping of force elements [√(N/m)], [m √(N/m)]; the
  /// same times √s. Empty: none.
  Eigen::MatrixXd sprung = {}, damped = {};
  /// In place of all but the spin, where springs swing other bodies by
  /// themselves: those are not in `sprung`.
  std::optional<SwingingBodies> swinging = std::nullopt;
  /// Names of these force elements.
  std::vector<std::string> left_out = {};
  /// Contacts or stops press that let go at other times.
  bool is_pressed_meanwhile = false;

  bool is_sprung() const { return sprung.cols() > 0 || swinging; }
  void leave_springs_out() {
    sprung = damped = Eigen::MatrixXd();
    swinging.reset();
  }
  std::vector<ContactZone> zones = {};  ///< as of the instant's load
};

/// Loads of a part over the motion, or its cases that share their supports.
struct LoadHistory {
  std::vector<Seat> seats;
  std::vector<InstantLoad> instants;
  /// Between them, of loads that stand between those of instants of another
  /// time: they excite vibration, and stress at rest no more. Rising.
  std::vector<InstantLoad> repeats = {};
  /// Up to there instants and repeats follow the loads [s].
  double followed_until = std::numeric_limits<double>::infinity();
  /// Motion::step_behind [s].
  double step_behind = 0.0;
  /// Motion::bends [s].
  std::vector<double> bends = {};
  /// Of the part in its mechanism, at the instant next to a time [s]; empty: it
  /// is free.
  std::function<SeatHold(double)> hold = {};
  /// The same without contacts and stops that let go at other times: what
  /// stands on those may lift off. Empty: the same.
  std::function<SeatHold(double)> lasting_hold = {};
  /// That of a mechanism at rest, whose friction breaks away and whose gas
  /// flows; absent: nothing yields otherwise.
  std::function<std::optional<SeatHold>(double)> hold_at_rest = {};
  /// When it counts: the loads are largest then [s].
  double hold_time = 0.0;
  /// Whether force elements hold the part as it vibrates: soft ones do not.
  bool springs_hold = false;
  /// Of rows of a file; nothing: a motion, or cases.
  std::optional<part::BetweenRows> rows = std::nullopt;
  /// Possible excess of loads between instants over those at the instants,
  /// over the largest [1].
  double unseen = 0.0;
  /// The share of it that joints carry at change points [1].
  double at_change_points = 0.0;
  /// The same where seats travel: a bending moment that is a parabola of the
  /// place rises by the square of a step over all the way in between [1].
  double slide_excess = 0.0;
  /// Notes for the user on how the seats were modelled, a line each.
  std::vector<std::string> notes = {};

  /// By what presses always. @pre `hold`.
  SeatHold hold_that_lasts(double time) const {
    return lasting_hold ? lasting_hold(time) : hold(time);
  }
  /// When it counts. @pre `hold`.
  SeatHold hold_that_counts() const {
    SeatHold counting = hold(hold_time);
    if (!springs_hold) counting.leave_springs_out();
    return counting;
  }
};

}  // namespace clevis::loads
