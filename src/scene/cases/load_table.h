#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "scene/text/value.h"

namespace clevis::scene {

/// Columns of a vector's components; −1: it has none of this component.
using VectorColumns = std::array<int, 3>;

/// Force and moment of one name, or the pressure on a group, in a LoadTable.
struct LoadColumns {
  std::string name;
  VectorColumns force{-1, -1, -1};
  VectorColumns moment{-1, -1, -1};
  int pressure = -1;
  std::string place;  ///< of its first column

  bool has_wrench() const;
};

/// Loads of a part over time, read from columns with units:
/// "time [s]", "NAME.force_x [N]", "NAME.moment_x [N m]", "GROUP.pressure
/// [MPa]", "acceleration_x [m/s^2]", "angular_velocity_x [rad/s]",
/// "angular_acceleration_x [rad/s^2]", "orientation_w" (to _z; quaternion of
/// the part's frame in the world).
class LoadTable {
 public:
  /// @throws Error I001, S012 if it is no such table, S002 for a column with
  ///   another title, S004 for a unit that does not fit, S005 for a field that
  ///   is no number, S006 where time falls back or a quaternion has no unit
  ///   length (1e-3).
  explicit LoadTable(const std::filesystem::path& file);

  std::size_t rows() const { return static_cast<std::size_t>(values_.rows()); }
  const std::vector<LoadColumns>& loads() const { return loads_; }
  bool has_acceleration() const { return has(acceleration_) || has(alpha_); }
  bool spins() const { return has(omega_); }
  bool has_orientation() const { return orientation_.front() >= 0; }

  double time(std::size_t row) const { return value(row, time_); }  ///< [s]
  /// Component that stands in a column [SI]; 0 without one.
  double value(std::size_t row, int column) const;
  Eigen::Vector3d vector(std::size_t row, const VectorColumns& columns) const;
  Eigen::Vector3d acceleration(std::size_t row) const;
  Eigen::Vector3d angular_velocity(std::size_t row) const;
  Eigen::Vector3d angular_acceleration(std::size_t row) const;
  const std::string& place(std::size_t row) const { return places_[row]; }
  /// From the part's frame to the world; needs has_orientation().
  Eigen::Quaterniond orientation(std::size_t row) const;

 private:
  struct Slot;

  static bool has(const VectorColumns& columns);
  std::optional<Slot> slot_of(const std::string& title,
                              const std::string& place);
  LoadColumns& load(const std::string& name, const std::string& place);
  void require_whole_orientation(const std::string& place) const;
  void require_rising_times() const;
  void require_spin_where_turning() const;
  void require_unit_length() const;

  std::vector<LoadColumns> loads_;
  int time_ = -1;
  VectorColumns acceleration_{-1, -1, -1};
  VectorColumns omega_{-1, -1, -1};
  VectorColumns alpha_{-1, -1, -1};
  std::array<int, 4> orientation_{-1, -1, -1, -1};  ///< w, x, y, z
  Eigen::MatrixXd values_;           ///< rows × columns of the file [SI]
  std::vector<std::string> places_;  ///< of the rows, file:line:column
};

}  // namespace clevis::scene
