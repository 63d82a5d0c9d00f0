#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/force_line.h"
#include "numerics/curves/cubic_spline.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// F = −stiffness (x − x₀) − damping (v − v₀) on a point of a body, from
/// ground; the target x₀ rests or follows splines.
struct ImpedanceElement {
  std::string name;
  ElementPoint point;
  Eigen::Vector3d target_W = Eigen::Vector3d::Zero();  ///< [m]
  std::array<numerics::CubicSpline, 3>
      path_W{};                   ///< by axis, instead; without times none
  double stiffness{}, damping{};  ///< [N/m], [N s/m]
  bool damps_absolute = false;    ///< v₀ = 0 whatever the target does
  std::string place;

  std::array<int, 2> bodies(const std::vector<JointDefinition>&) const {
    return {kGround, point.body};
  }
};

ElementProperties properties(const ImpedanceElement& impedance);
/// @param impedance  outlives the result.
std::unique_ptr<ActingElement> place(const ImpedanceElement& impedance,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
