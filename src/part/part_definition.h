#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "part/load_series.h"
#include "part/material.h"
#include "part/slide_contact.h"
#include "part/supports.h"

namespace clevis::part {

/// Limits that the user sets for the part.
struct Limits {
  std::optional<double> safety_factor;  ///< yield strength / peak, >= this [1]
  std::optional<double> deflection;     ///< [m], <= this
  std::optional<double> buckling;       ///< linear buckling factor, >= this [1]
  /// Judge the part by its stress away from singular zones.
  bool exclude_singular_zones = false;
};

/// Group of the part's surface on which a joint of the mechanism acts.
struct Seat {
  std::string joint;        ///< joint of the scene
  std::string group;        ///< physical group of the mesh
  SlideContact slide = {};  ///< of a joint that slides
};

/// Groups of the part on which the effort of a drive acts.
struct DriveSeat {
  std::string drive;  ///< joint that is driven
  std::string group;  ///< face that takes the effort as a pressure
  /// Groups that feel the same pressure when the drive pushes (a cylinder
  /// wall); none for a screw or a rod.
  std::vector<std::string> pressurized;
};

/// Groups of the part on which a force of the scene acts.
struct ForceSeat {
  std::string force;
  std::string group;  ///< bore or face that takes it
  /// Groups that feel the pressure of the gas, or of an effort that pushes.
  std::vector<std::string> pressurized;
  std::string chamber = {};  ///< of a gas cylinder: whose pressure
};

/// Displacement or stress component that the user asks for at a point.
struct Probe {
  std::string name;
  Eigen::Vector3d at;  ///< in L [m]
  std::string quantity;  ///< von_mises, stress_xx … stress_yz, displacement_x …
  std::optional<double> reference = {};  ///< known value, for studies [SI]
};

/// Whether a quantity of a probe is a displacement [m]; else a stress [Pa].
inline bool is_displacement(std::string_view quantity) {
  return quantity.starts_with("displacement_");
}

/// A part checked alone, without a mechanism.
struct LoadCaseDefinition {
  std::string name;
  std::map<std::string, Eigen::Vector3d> pins;      ///< force on bore group [N]
  std::map<std::string, double> pressure;           ///< pushes on the face [Pa]
  std::map<std::string, Eigen::Vector3d> traction;  ///< [Pa]
  part::Supports fixed;                             ///< components held at zero
  Foundations foundations;
  std::vector<std::string> held_by_pin;  ///< bores whose pins hold the part
  Eigen::Vector3d acceleration =
      Eigen::Vector3d::Zero();  ///< [m/s²] of the
                                ///< part minus gravity: the body force is
                                ///< -density * acceleration
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();      ///< [rad/s]
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();  ///< [rad/s²]
  std::vector<Probe> probes;
};

/// A blow on a part that rests on its supports.
struct ImpactDefinition {
  std::string name;
  std::string group;  ///< physical group that is struck
  /// Of the striker's velocity, unit.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  part::Supports fixed;  ///< components held at zero
  /// Contact or stop of the mechanism whose hardest impact it is; empty: the
  /// three below are given.
  std::string contact;
  double mass{};   ///< of the striker [kg]
  double speed{};  ///< [m/s]
  double force{};  ///< that goes on pushing it [N]
  /// Of the contact: force per approach^exponent [N/m^exponent].
  double stiffness{};
  double exponent = 1.0;
  std::optional<double> duration;  ///< that is computed [s]
  std::string place;               ///< file:line:column
};

/// A part of the scene as the user wrote it. Frame L is the mesh's own.
struct PartDefinition {
  std::string name;
  std::filesystem::path geometry;  ///< .geo or empty
  std::filesystem::path mesh;      ///< .msh; derived from geometry if not given
  double length_unit{};            ///< metres per unit of the mesh file
  std::optional<double> thickness;  ///< the mesh is a plate's mid-plane [m]
  Material material;
  std::vector<Seat> seats;
  std::vector<DriveSeat> drive_seats;
  std::vector<ForceSeat> force_seats;
  Limits limits;
  double damping{};  ///< of its vibrations, over the critical [1]
  /// Its joints neither yield nor have play: all that they hold counts in
  /// buckling and second order, also what is more than six conditions.
  bool ideal_joints = false;
  std::vector<LoadCaseDefinition> cases;
  std::vector<LoadSeries> series;
  std::vector<ImpactDefinition> impacts;
  std::string place;  ///< file:line:column of the part's table
};

}  // namespace clevis::part
