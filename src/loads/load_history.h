#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "part/part_definition.h"

namespace clevis::loads {

/// How a seat takes its wrench.
enum class SeatKind {
  kBearing,   ///< cylinder pressed by a pin (bore) or by its guide (piston)
  kTraction,  ///< traction that varies linearly over the group
  kPressure,  ///< face under a drive's effort; the effort also pressurizes
              ///< the `pressurized` groups when it pushes
};

/// A group of the part's surface where the mechanism acts.
struct Seat {
  std::string name;   ///< joint, drive or case entry
  std::string group;  ///< physical group
  SeatKind kind{};
  Eigen::Vector3d p_LS = Eigen::Vector3d::Zero();  ///< reference point [m]
  std::vector<std::string> pressurized;
};

/// Force and moment on the part, in L; the moment about the seat's p_LS.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [N m]
};

/// Rigid motion of the part that its material feels, in L. The body force at
/// a point Q is −ρ (acceleration + α×p_LQ + ω×(ω×p_LQ)).
struct RigidAcceleration {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< of Lo, minus
                                                           ///< gravity [m/s²]
  Eigen::Vector3d alpha = Eigen::Vector3d::Zero();         ///< [rad/s²]
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();         ///< [rad/s]
};

/// All loads of a part at an instant (or in a case); in balance unless fixed.
struct InstantLoad {
  std::string label;  ///< "t = 0.31 s" or the case's name
  double time{};      ///< [s]; 0 for a case
  std::vector<Wrench> wrenches;  ///< one per seat
  RigidAcceleration rigid;
};

/// Loads of a part over the motion, or its cases that share their supports.
struct LoadHistory {
  std::vector<Seat> seats;
  std::vector<InstantLoad> instants;
};

}  // namespace clevis::loads
