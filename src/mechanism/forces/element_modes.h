#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/motion.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

// Modes of the force elements of a mechanism. Two events per element: 2 k and
// 2 k + 1 of element k.

/// Whether there are events.
bool may_switch(const ForceModel& forces);
/// Whether friction holds any line.
bool any_sticks(const ForceModel& forces);
int event_count(const ForceModel& forces);
/// Modes by event.
std::vector<int> modes(const ForceModel& forces);

/// Puts what is positive while the modes hold, by event, in units of the
/// elements (SI). @param state  in which what sticks has the effort of its row.
void put_event_values(const ForceModel& forces, const ForceState& state,
                      Eigen::VectorXd& values);
/// Sets the modes that a state alone suggests.
void choose_modes(const ForceState& state, ForceModel& forces);
/// Goes to the next mode of what put_event_values() found at zero.
void pass_event(int event, const ForceState& state, ForceModel& forces);
/// Changes at that event, and in friction, whose modes are decided together.
/// @param t  of the event [s]. @param before  modes().
std::vector<MotionEvent> mode_changes(const ForceModel& forces, int event,
                                      double t, const std::vector<int>& before);
/// Dry friction that moves against its mode by more than speeds may err: at
/// rest it moves, or slips with its own force. @return its element; size() if
/// there is none.
std::size_t line_against_its_mode(const ForceModel& forces,
                                  const ForceState& state);

}  // namespace clevis::mechanism
