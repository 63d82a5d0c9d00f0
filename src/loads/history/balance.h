#pragma once

#include <string>
#include <vector>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"
#include "part/mass_properties.h"

namespace clevis::loads {

/// Force and moment about Lo that the inertia of a rigid part adds to its
/// loads (d'Alembert): −m a_Cm and −(c × m a + I_Lo α + ω × I_Lo ω).
Wrench inertia_load(const RigidAcceleration& rigid,
                    const part::MassProperties& mass);

/// Diameter of the smallest box about all groups and the centre of mass, or
/// twice the part's radius of gyration if that is larger [m]: the length that
/// makes moments and gaps of a part comparable.
double part_size(const std::vector<GroupGeometry>& groups,
                 const part::MassProperties& mass);

/// The group of that name.
/// @throws Error M003 with the names there are.
const GroupGeometry& find_group(const std::vector<GroupGeometry>& groups,
                                const std::string& name,
                                const std::string& place);

/// A group that a pin presses on.
/// @throws Error L002 if it is not a circular cylinder.
void require_cylinder(const GroupGeometry& group, const std::string& place);

/// "(1, 0, -2.5)" for messages; components that are round-off of `scale` are
/// shown as 0. Scale in the units of v.
std::string vector_text(const Eigen::Vector3d& v, double scale);

/// Force [N] and moment about `to` [N m] of a force and a moment about `from`;
/// points [m], all in one frame.
Wrench about(const Eigen::Vector3d& force, const Eigen::Vector3d& moment,
             const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Whether a group is a circular cylinder, whole all round: without gaps, or in
/// rings on one axis, as the ears of a fork.
bool is_full_cylinder(const GroupGeometry& group);

/// |∫ n dA| over the area of a face that no longer closes round [1].
inline constexpr double kOpenFace = 0.3;

/// Whether it is one that closes about a pin but for a quarter of a turn: a
/// keyway or a slot takes less, a saddle has less.
bool closes_about_pin(const GroupGeometry& group);

/// Residual force [N] and moment about Lo [N m] of an instant: seats, surface
/// loads and inertia.
Wrench residual(const LoadHistory& history, const InstantLoad& instant,
                const part::MassProperties& mass);

/// Residual of the loads of an instant, and scales of these loads.
struct Imbalance {
  Wrench left;            ///< moment about Lo [N], [N m]
  double force_scale{};   ///< sum of all forces' magnitudes, inertia's too [N]
  double moment_scale{};  ///< of moments and forces × size [N m]

  /// The larger of force and moment over its scale [1].
  double relative() const;
};
/// @param size  part_size() [m].
Imbalance imbalance(const LoadHistory& history, const InstantLoad& instant,
                    const part::MassProperties& mass, double size);

/// Loads of a case that are given to three digits leave up to this part of
/// them; more is a load that was forgotten.
inline constexpr double kLargestRelief = 1e-3;

/// Accelerations above it are asked about, as of mm/s² that were typed as m/s²
/// or a pin of the wrong sign; pistons and blows reach it, too [m/s²].
inline constexpr double kEarthGravity = 9.81;
inline constexpr double kHardAcceleration = 50.0 * kEarthGravity;

/// Acceleration by which a free part balances a residual of its loads.
RigidAcceleration relieving_acceleration(const Wrench& left,
                                         const part::MassProperties& mass);

/// Gives the part the acceleration by which its inertia takes up a rest of the
/// balance up to kLargestRelief, and notes the rest in `relief`.
/// @param size  part_size() [m].
/// @throws Error L001 if more is left.
void relieve(const LoadHistory& history, const part::MassProperties& mass,
             double size, const std::string& place, InstantLoad& instant);

/// Lets the inertia of one mesh take up loads that were balanced by that of
/// another of the same body: curved faces make masses differ by the size of the
/// cells.
void float_on(const part::MassProperties& mass, LoadHistory& history);

/// Refuses a history in which an instant is out of balance.
///
/// The load of an instant is the sum of the magnitudes of its forces and
/// inertia (of its moments plus these forces times the part's size). An
/// instant that carries less than 1e-3 of the largest one is measured against
/// that, because round-off of the motion is relative to its largest load, and
/// one of less than 1e-6 of the mechanism's against that.
/// @param size  part_size() [m]. @param of_mechanism  its largest reaction [N].
/// @throws Error L001 with the residual force and moment.
void require_balance(const LoadHistory& history,
                     const part::MassProperties& mass, double size,
                     const std::string& place, double of_mechanism = 0.0);

}  // namespace clevis::loads
