#pragma once

#include <vector>

#include <Eigen/Core>

#include "loads/load_history.h"

namespace clevis::assessment {

/// How much a peak of the motion may be higher between the instants [Pa].
///
/// Two instants within 1e-8 of the motion's duration stand on both sides of
/// an event: loads may jump there, and nothing lies between. The pieces of the
/// motion that such pairs separate are judged each by itself.
/// @param instants  of a load set; its cases stand behind the motion, at time
///   0, and have no doubt.
/// @param peak  at least one per instant of the motion [Pa].
double time_doubt(const std::vector<loads::InstantLoad>& instants,
                  const Eigen::VectorXd& peak);

}  // namespace clevis::assessment
