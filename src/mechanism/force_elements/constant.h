#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/force_line.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// A constant force and moment on a body, directions fixed in W. Its effort is
/// the size of the force, its rate that of the point along it.
struct ConstantForce {
  std::string name;
  ElementPoint point;
  Eigen::Vector3d f_W = Eigen::Vector3d::Zero();  ///< [N]
  Eigen::Vector3d t_W = Eigen::Vector3d::Zero();  ///< [N m]
  std::string place;

  std::array<int, 2> bodies(const std::vector<JointDefinition>&) const {
    return {kGround, point.body};
  }
};

ElementProperties properties(const ConstantForce& force);
/// @param force  outlives the result.
std::unique_ptr<ActingElement> place(const ConstantForce& force,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
