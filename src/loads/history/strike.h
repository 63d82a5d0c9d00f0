#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

namespace clevis::loads {

/// Force of a contact over its approach δ: stiffness δ^exponent.
///
/// Infinite stiffness is the ideal velocity step: the struck face takes the
/// striker's speed at once. Its stress at the root grows with every finer mesh.
struct ContactSpring {
  double stiffness{};      ///< > 0 [N/m^exponent]
  double exponent = 1.0;   ///< >= 1; 1.5: Hertz [1]
  bool bilateral = false;  ///< the striker cannot leave: the spring pulls too
};

/// A rigid striker that touches a part at rest at t = 0 and moves along a
/// line. The contact acts on the mean displacement of the group along it.
struct Strike {
  std::string name;
  std::string group;  ///< physical group that is struck
  /// Of the striker's velocity, unit, in L.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  double mass{};     ///< of the striker, > 0 [kg]
  double speed{};    ///< at t = 0, >= 0 [m/s]
  double force = 0;  ///< constant, on the striker along the direction [N]
  ContactSpring contact;
  std::optional<double> duration = {};  ///< that is computed [s]
};

}  // namespace clevis::loads
