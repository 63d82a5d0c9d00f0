#pragma once

#include <Eigen/Core>

#include "loads/history/load_history.h"

namespace clevis::assessment {

/// How much a peak of the motion may be higher between the instants [Pa].
///
/// The pieces of the motion that events separate (loads::kEventSides) are
/// judged each by itself. Where the motion was searched its loads between two
/// instants lie on the line between theirs but for LoadHistory::unseen: the
/// stress, a convex function of the loads, is no higher but for that part of
/// it. Of rows of a
/// file between which loads change evenly it is none, but of the way on which
/// they do so in another frame than the part's or with its spin: instants on
/// that are judged each by itself. Where a seat travels,
/// LoadHistory::slide_excess of it is added.
/// @param history  of a load set; its cases stand behind the motion, at time
///   0, and have no doubt.
/// @param peak  at least one per instant of the motion [Pa].
double time_sampling_error(const loads::LoadHistory& history,
                           const Eigen::VectorXd& peak);

}  // namespace clevis::assessment
