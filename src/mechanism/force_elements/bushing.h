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

/// An elastic bearing between frames J on bodies a and b, unstrained where
/// they coincide. By s = K q + C q': force −s on b along the axes of J on a,
/// moments conjugate to the rotation vector. q holds the displacement of b's
/// origin in J on a [m], then the rotation vector from J on a to J on b [rad],
/// below half a turn.
struct BushingElement {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  std::string name;
  ElementPoint a, b;                                   ///< origins of J
  Eigen::Matrix3d R_AJ = Eigen::Matrix3d::Identity();  ///< J in L of a
  Eigen::Matrix3d R_BJ = Eigen::Matrix3d::Identity();  ///< J in L of b
  Matrix6 stiffness = Matrix6::Zero();  ///< [N/m], [N], [N m]; symmetric
  Matrix6 damping = Matrix6::Zero();    ///< the same times [s]
  std::string place;

  std::array<int, 2> bodies(const std::vector<JointDefinition>&) const {
    return {a.body, b.body};
  }
};

/// Position and effort are the size of displacement and force; channels are
/// the moment's size and the energy ½ qᵀ K q.
ElementProperties properties(const BushingElement& bushing);
/// @param bushing  outlives the result.
std::unique_ptr<ActingElement> place(const BushingElement& bushing,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
