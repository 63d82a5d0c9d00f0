#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/joints/joint_definition.h"

namespace clevis::mechanism {

/// Action of a force element on one of its bodies, in W.
struct ElementAction {
  BodyIndex body = kGround;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< point of attack [m]
  Eigen::Vector3d f_W = Eigen::Vector3d::Zero();  ///< [N]
  Eigen::Vector3d t_W = Eigen::Vector3d::Zero();  ///< about p_W [N m]
};

/// A chamber of one section of a gas cylinder at an instant.
struct GasChamberState {
  double volume{};                   ///< [m³]
  double pressure{}, temperature{};  ///< absolute [Pa], [K]
  double mass{};                     ///< [kg]
  double inflow{}, outflow{};        ///< from supply, to environment [kg/s]
  double taken{}, released{};        ///< since the start [kg]
};

/// Interface of gas and mechanism that communicate in steps.
struct GasInterface {
  double since{};                ///< the last communication [s]
  double q{}, rate{};            ///< of the line, what the gas knew then
  double effort{};               ///< on the mechanism since then [N]
  double gas_q{}, gas_effort{};  ///< of the gas, at this instant
  double work_on_mechanism{}, work_of_gas{};  ///< since the start [J]
};

/// A motor at an instant.
struct MotorState {
  double speed{};                      ///< ω of the rotor [rad/s]
  double voltage_d{}, voltage_q{};     ///< [V]
  double current_d{}, current_q{};     ///< [A]
  double torque{};                     ///< T [N m]
  double power{}, loss{};              ///< electrical, of the windings [W]
  double supplied{}, lost{}, given{};  ///< since the start [J]
  double stored{};                     ///< in the windings [J]
};

/// Response of a force element at an instant, as a result.
struct ElementState {
  double position{}, rate{};  ///< of its line; a contact's depth [m] or [rad]
  double effort{};     ///< on b, > 0 pushes apart; a contact's normal force
  double friction{};   ///< of a contact [N]
  double power{};      ///< [W]
  bool unique = true;  ///< false: friction at rest that lines share somehow
  std::array<ElementAction, 2> actions{};    ///< on a and on b
  std::vector<double> channels{};            ///< by ElementProperties::channels
  std::vector<GasChamberState> chambers{};   ///< of a gas cylinder
  std::optional<GasInterface> interface {};  ///< of gas that is coupled
  std::optional<MotorState> motor{};
};

}  // namespace clevis::mechanism
