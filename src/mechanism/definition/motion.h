#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/definition.h"
#include "mechanism/element_base/element_state.h"

namespace clevis::mechanism {

/// Motion of a body at an instant; L is its frame, Lo the origin.
struct BodyState {
  Pose pose;
  Eigen::Vector3d v_WLo = Eigen::Vector3d::Zero();     ///< [m/s]
  Eigen::Vector3d w_WL = Eigen::Vector3d::Zero();      ///< [rad/s], in W
  Eigen::Vector3d a_WLo = Eigen::Vector3d::Zero();     ///< [m/s²]
  Eigen::Vector3d alpha_WL = Eigen::Vector3d::Zero();  ///< [rad/s²], in W
};

/// Force and moment of a joint on body b at the origin of its frame J on b,
/// without the effort of a drive; body a feels the opposite at the same point.
/// In W.
struct JointReaction {
  Eigen::Vector3d p_WJ = Eigen::Vector3d::Zero();  ///< origin of J on b [m]
  Eigen::Vector3d f_W = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d t_W = Eigen::Vector3d::Zero();   ///< about p_WJ [N m]
  bool unique = true;  ///< false where redundancy leaves it undetermined
  /// Axes of frame J on body a: columns.
  Eigen::Matrix3d R_WJ = Eigen::Matrix3d::Identity();
  /// The same by component: force, then moment, along x, y, z of frame J.
  /// The joints' compliance shares reactions that are not unique. A planar
  /// mechanism without loads across its plane has none across it either:
  /// those count as unique.
  std::array<bool, 6> unique_components{true, true, true, true, true, true};
  /// Largest change of a component, to first order, if each joint's
  /// compliance is doubled or halved [N], [N m].
  std::array<double, 6> spread{};

  /// Force [N], then moment [N m], in frame J.
  Eigen::Matrix<double, 6, 1> components() const {
    Eigen::Matrix<double, 6, 1> w;
    w << R_WJ.transpose() * f_W, R_WJ.transpose() * t_W;
    return w;
  }
};

/// Force of the teeth on the wheel of a coupling's first joint, at the pitch
/// point; the other wheel feels the opposite there. In W.
struct ToothForce {
  Eigen::Vector3d f_W = Eigen::Vector3d::Zero();  ///< [N]
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
};

/// Forces and moments of a coupling on the bodies b of its two joints, at the
/// origins of their frames J; the bodies a feel the opposite at the same
/// points. In W. Where its teeth are resolved their force acts in place of all
/// of these.
struct CouplingState {
  double effort{};  ///< generalised force on coordinate 1 [N] or [N m]; on
                    ///< coordinate 2 it is −ratio times that
  Eigen::Vector3d f_1_W = Eigen::Vector3d::Zero();  ///< [N]
  Eigen::Vector3d t_1_W = Eigen::Vector3d::Zero();  ///< [N m]
  Eigen::Vector3d f_2_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d t_2_W = Eigen::Vector3d::Zero();
  std::optional<ToothForce> teeth = std::nullopt;  ///< if resolved
  bool unique = true;
};

/// Prescribed coordinate and what it takes.
struct DriveState {
  double position{}, rate{}, acceleration{};  ///< [m] or [rad] …
  double effort{};  ///< [N] or [N m]; power = effort * rate; > 0 pushes apart
  /// Force, or moment, on body b per effort; a unit vector but for angles of
  /// spherical joints.
  Eigen::Vector3d axis_W = Eigen::Vector3d::Zero();
};

/// A change of an element's mode: touch, release, stick, slip.
struct MotionEvent {
  double t{};  ///< [s]
  int element{};
  std::string what;
};

/// A contact, or an end of a stop, from its first touch until it lets go. Of a
/// stop in a joint that turns: angles, moments, inertias.
struct Impact {
  int element{};
  int end{};                ///< of a stop: 0 lower, 1 upper
  double t{};               ///< of the touch [s]
  double approach_speed{};  ///< along the normal [m/s] or [rad/s]
  /// Effective masses of a (a contact's plane) and b there along the normal,
  /// joints and drives holding [kg] or [kg m²]; infinite where they cannot give
  /// way.
  double mass_a{}, mass_b{};
  double mass{};   ///< of their relative motion [kg] or [kg m²]
  double force{};  ///< of all else, at the touch; > 0 presses [N] or [N m]
  std::optional<double> duration;  ///< [s]; none: it still presses at the end
  double exit_speed{};             ///< with which they part [m/s] or [rad/s]
  double peak_force{};             ///< [N] or [N m]
  double peak_at{};                ///< [s]
  double impulse{};                ///< [N s] or [N m s]
};

struct Instant {
  double t{};  ///< [s]
  std::vector<BodyState> bodies;
  std::vector<JointReaction> joints;
  std::vector<DriveState> drives;
  std::vector<CouplingState> couplings;
  std::vector<ElementState> elements;
  /// Rigid reactions have no bound here: those of joints that give way stand
  /// in their place, and balance in the deflected position only.
  bool is_change_point = false;
  double closure_error{};        ///< largest joint gap [m]
  double power_balance_error{};  ///< |drives + loads − d(kinetic)/dt| over the
                                 ///< largest of them over the motion [1]
};

/// A change point that the motion passed between two instants. It stayed on
/// its branch, but rigid reactions grow without bound towards the point, so
/// their largest value is a matter of sampling.
struct ChangePoint {
  double t_before{}, t_after{};  ///< instants before and behind [s]
  double t{};                    ///< the point itself [s]
  /// The same, with the reactions of joints that give way; nothing where even
  /// those do not hold the loads.
  std::optional<Instant> at = std::nullopt;
};

/// Method and effort of an integrated motion.
struct IntegrationSummary {
  std::string method;  ///< "DOP853", "Radau IIA", or both
  long steps{}, rejected{}, evaluations{};
  long factorisations{};  ///< of Radau IIA's pairs of matrices
  long implicit_steps{};  ///< those of Radau IIA
  /// Largest |kinetic energy − work of all forces| [J], and over the largest
  /// of them in the motion [1].
  double energy_error{}, relative_energy_error{};
};

/// Why a motion was integrated although `motion` did not ask for it.
struct LeftFree {
  int freedom{};  ///< degrees that no drive fixes; 0: forces have a history
  /// Joint coordinates that the drives leave loose, as names.
  std::vector<std::string> coordinates;
};

/// Links that are strained between joints whose reactions equilibrium leaves
/// open, which is not in how these are shared: bodies.
struct UnsharedStrains {
  std::vector<int> spun;    ///< rigid ones, by their spin
  std::vector<int> loaded;  ///< elastic ones, by forces beside their joints
};

/// Extent of the search for the largest loads of a motion between instants.
struct LoadSearch {
  long looks{};       ///< states that were solved
  bool ended{};       ///< before all was looked at, for lack of looks
  double ended_at{};  ///< [s]
  /// Possible excess of loads between instants over those at the instants
  /// beside them, over the largest of their kind: by body, the greatest of all
  /// that act on it [1].
  std::vector<double> bodies;
};

/// The whole history, what `loads` and `report` take.
struct Motion {
  std::vector<Instant> instants;
  /// More of them, whose loads stand between those of instants of another time
  /// or are small beside the largest: they load nothing more, but excite
  /// vibration. Rising.
  std::vector<Instant> repeats;
  /// Up to there no load is off the curves through instants and repeats [s].
  double followed_until = std::numeric_limits<double>::infinity();
  /// Behind that the shortest step that would follow them; 0: not known [s].
  double step_behind = 0.0;
  /// Laws and tables bend there: loads may, between two lines. Rising [s].
  std::vector<double> bends;
  std::vector<ChangePoint> change_points;
  std::vector<MotionEvent> events;
  std::vector<DriveJump> drive_jumps;
  std::vector<Impact> impacts;  ///< of integrated motions, as they begin
  std::optional<IntegrationSummary> integration;  ///< of integrated motions
  std::optional<LeftFree> left_free;
  UnsharedStrains unshared;
  std::optional<LoadSearch> search;  ///< with SimulationSettings::at_peaks
};

}  // namespace clevis::mechanism
