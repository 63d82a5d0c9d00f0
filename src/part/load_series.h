#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "part/supports.h"

namespace clevis::part {

/// Where a wrench of a load series acts.
struct SeriesSeat {
  std::string name;   ///< in the file's columns
  std::string group;  ///< physical group of the mesh
  bool is_face{};     ///< takes it as a linear traction; else a pin's bore
  /// Point that the moments are about, in L [m]; nothing: the middle of the
  /// bore, the centroid of the face.
  std::optional<Eigen::Vector3d> about = std::nullopt;
};

/// Loads of a part at one time, in L.
struct SeriesInstant {
  double time{};                         ///< [s]
  std::vector<Eigen::Vector3d> forces;   ///< one per seat [N]
  std::vector<Eigen::Vector3d> moments;  ///< one per seat [N m]
  std::vector<double> pressures;         ///< one per group that has one [Pa]
  /// Of the part's origin, minus gravity [m/s²].
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();      ///< [rad/s]
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();  ///< [rad/s²]
  bool is_between_rows{};  ///< in no row of the file, but between two
};

/// What loads do between the rows of a file.
enum class BetweenRows {
  kUnknown,  ///< what they may do there is in the band
  kLinear
};

/// Loads of a part over time, as another program or a test bench wrote them.
struct LoadSeries {
  std::string name;
  std::vector<SeriesSeat> seats;
  std::vector<std::string> pressurized;  ///< groups
  std::vector<SeriesInstant> instants;   ///< times never fall
  BetweenRows between = BetweenRows::kUnknown;
  bool has_acceleration{};  ///< else the part's inertia balances its loads
  /// Largest rest of the balance that inertia takes up where accelerations are
  /// given, over the largest load of the series [1].
  double largest_imbalance{};
  Supports fixed;
  Foundations foundations;
  /// Bores of the seats whose pins hold the part: nothing else does. Empty:
  /// what holds it is not known.
  std::vector<std::string> held_by_pin = {};
  std::string place;  ///< file:line:column of the table
};

}  // namespace clevis::part
