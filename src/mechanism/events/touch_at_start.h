#pragma once

#include <Eigen/Core>

#include "mechanism/equations_of_motion/equations_of_motion.h"

namespace clevis::mechanism {

/// Modes of contacts and ends of stops that a motion starts at, where the sign
/// of the depth is round-off. What rests there presses where its bodies
/// accelerate together, else it is open. What closes with speed is open: an
/// impact of the first instant.
/// @param t  of the start [s]. @param y  the state then, of StateLayout; modes
///   are chosen.
/// @return whether there is such an end.
bool choose_modes_of_touching(EquationsOfMotion& equations, double t,
                              const Eigen::VectorXd& y);

}  // namespace clevis::mechanism
