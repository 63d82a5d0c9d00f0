#pragma once

#include <Eigen/Core>

namespace clevis::mechanism {

/// Part of a body that guides a slide: it carries forces and moments across the
/// slide by forces at its two ends.
struct Guide {
  double length{};      ///< [m]; 0: forces alone count
  bool is_on_b = true;  ///< of which body; its middle is J on that
};

/// Force [N], then moment [N m], of a joint on b at J on b, along x, y, z of J.
using JointLoad = Eigen::Matrix<double, 6, 1>;

/// Forces across a slide at the ends of its guide, columns, in x and y of J
/// [N]. They are linear in the load. Without a length: all at one end.
/// @param q  from J on a to J on b along z [m].
Eigen::Matrix2d end_forces(const Guide& guide, double q, const JointLoad& load);

/// What friction in a guide is proportional to: the sum of their sizes [N].
double pressing_force(const Eigen::Matrix2d& end_forces);

}  // namespace clevis::mechanism
