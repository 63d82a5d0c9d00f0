#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::report {

/// A file that the result was made from.
struct ViewInput {
  std::filesystem::path file;
  std::string role;  ///< "scene", "mesh of AB", "geometry of AB"
};

/// Content of pictures beside the parts: the mechanism over its motion, and
/// what it was made from.
struct MotionView {
  std::string version;                        ///< of clevis
  std::string scene;                          ///< the scene's name
  std::vector<ViewInput> inputs;              ///< the scene first
  mechanism::MechanismDefinition definition;  ///< without bodies: none
  mechanism::Motion motion;
  /// Times at which parts are worst [s]: their instants are kept.
  std::vector<double> worst_times;
};

/// Positions in the motion of the instants that are told: all up to `most`,
/// else as many uniform ones, and in either case those with the largest
/// reaction of each joint, effort of each drive and force, and the worst times;
/// and up to half of `most` where blows leave the straight lines between these.
std::vector<std::size_t> kept_instants(const MotionView& view,
                                       std::size_t most);

/// One JSON document (docs/results.md, "The files of the report").
/// @throws Error I001 if an input cannot be read.
std::string motion_view_json(const MotionView& view);

}  // namespace clevis::report
