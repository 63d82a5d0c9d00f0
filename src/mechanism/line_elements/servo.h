#pragma once

#include <memory>
#include <optional>

#include "mechanism/drives/drive_definition.h"
#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/force_line.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// Follows a reference r(t): effort −stiffness (q − r) − damping (q' − r'), at
/// most `limit`.
struct ServoLaw {
  DriveDefinition reference;    ///< its law; joint and coordinate unused
  double stiffness{};           ///< [N/m] or [N m/rad]
  double damping{};             ///< [N s/m] or [N m s/rad]
  std::optional<double> limit;  ///< [N] or [N m]
};

/// Its channel is the target. @param law  outlives the result.
ElementProperties properties(const ServoLaw& law);
/// @param law  outlives the result.
std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const ServoLaw& law,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
