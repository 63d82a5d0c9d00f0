#pragma once

#include <string>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "mechanism/structure/structure.h"
#include "report/summary/drive_jump_output.h"
#include "report/summary/impact_output.h"

namespace clevis::report {

/// The largest value over the motion and when it occurs first.
struct Peak {
  double value{};
  double at{};  ///< [s]
};

struct JointPeaks {
  std::string name;
  Peak force;   ///< [N]
  Peak moment;  ///< about the origin of the joint's frame on body b [N m]
};

/// A component of a joint's reaction that equilibrium leaves open at some
/// instant, where its magnitude is largest.
struct OpenComponent {
  std::string joint;
  std::string component;  ///< "force x" … "moment z", in the joint's frame
  bool is_moment{};
  Peak peak;
  double spread{};  ///< there; see JointReaction::spread [N] or [N m]
};

/// A change point that the motion passed.
struct PassedChangePoint {
  double at{};  ///< [s]
  /// Largest force of joints that give way, in which joint; an empty name: they
  /// do not hold the loads [N].
  double largest_force{};
  std::string joint;
};

enum class EffortKind { kForce, kTorque };

struct DrivePeak {
  std::string name;  ///< of the driven joint
  EffortKind kind{};
  Peak effort;  ///< magnitude [N] or [N m]
};

/// Summary of the motion that loads the parts.
struct MechanismSummary {
  int mobility{};
  int redundant_constraints{};
  int instants{};
  double max_closure_error{};        ///< [m]
  double max_power_balance_error{};  ///< [1]
  /// Joints whose reaction equilibrium leaves undetermined at some instant;
  /// the one by the joints' compliance is taken.
  std::vector<std::string> not_unique;
  std::vector<OpenComponent> open_components{};
  std::vector<JointPeaks> joints;
  std::vector<DrivePeak> drives;
  std::vector<PassedChangePoint> change_points{};
  std::vector<NamedImpact> impacts{};
  std::vector<NamedDriveJump> drive_jumps{};
  std::vector<std::string> notes{};  ///< see motion_notes()
  /// Instants just at one: their loads balance in the deflected position only
  /// and take no part in those of the parts.
  int instants_left_out{};
};

/// @pre `structure` and `motion` belong to `definition`.
MechanismSummary summarise(const mechanism::MechanismDefinition& definition,
                           const mechanism::Structure& structure,
                           const mechanism::Motion& motion);

}  // namespace clevis::report
