#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/definition.h"
#include "mechanism/motion.h"
#include "mechanism/slide_lever_closed_form.h"
#include "mechanism/structure.h"
#include "report/bearing_output.h"

namespace clevis::report {

/// The source's closed form beside the simulation at one instant.
struct SlideLeverRow {
  double t{};                 ///< [s]
  double cylinder_length{};   ///< l_x [m]
  Eigen::Vector2d simulated;  ///< C [m]
  double simulated_DC{};      ///< distance of C from D [m]
  mechanism::SlideLeverPosition corrected, published;
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

/// One JSON document: structure, summary, peaks, markers, closed form.
std::string motion_json(const MotionReport& report);

/// Every joint at every instant: what it does to body b, in W and in the
/// frame of b, and what it does to a in the frame of a. Without the efforts of
/// drives, which stand in motion.csv.
std::string reactions_csv(const MotionReport& report);

/// One line per instant: pose, velocity, acceleration of every body, the
/// markers and the drives.
std::string motion_csv(const MotionReport& report);

/// Writes reactions.csv, motion.csv, with forces that depend on the motion
/// forces.csv and events.csv, with bearings bearings.csv, and, last,
/// simulate.json into `folder`.
/// @throws Error I002; F003 if a number is not finite.
void write_motion_files(const MotionReport& report,
                        const std::filesystem::path& folder);

}  // namespace clevis::report
