#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "machine/devices/slide_lever_closed_form.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "mechanism/structure/structure.h"
#include "report/machine/bearing_output.h"

namespace clevis::report {

/// Closed form of [LandingGear] beside the simulation at one instant.
struct SlideLeverRow {
  double t{};                 ///< [s]
  double cylinder_length{};   ///< l_x [m]
  Eigen::Vector2d simulated;  ///< C [m]
  double simulated_DC{};      ///< distance of C from D [m]
  machine::SlideLeverPosition corrected, published;
  double simulated_ratio{};  ///< speed of C over that of the cylinder [1]
};

/// The closed form at the first, middle and last instant.
struct SlideLeverComparison {
  std::string marker;
  std::string body;             ///< of the marker
  double rotation{};            ///< of that body over the motion, about z [rad]
  double link_DC{};             ///< |DC| as it is [m]
  double largest_DC_error{};    ///< of the corrected form, over all instants,
                                ///< relative [1]
  double largest_C_distance{};  ///< corrected to simulated C, all instants [m]
  std::vector<SlideLeverRow> rows;
};

/// Everything that `clevis simulate` tells.
struct MotionReport {
  std::string version;  ///< of clevis
  std::string scene;    ///< the scene's name
  mechanism::MechanismDefinition definition;
  mechanism::Structure structure;
  mechanism::Motion motion;
  std::optional<SlideLeverComparison> slide_lever;
  std::vector<BearingReport> bearings;
};

/// Position of a marker in W [m].
Eigen::Vector3d marker_position(const mechanism::MarkerDefinition& marker,
                                const mechanism::Instant& instant);

/// Indices of the first, middle and last instant, without repetition.
std::vector<std::size_t> shown_instants(const mechanism::Motion& motion);

}  // namespace clevis::report
