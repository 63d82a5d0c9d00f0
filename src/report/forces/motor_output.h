#pragma once

#include <array>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "report/summary/motion_report.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Columns of forces.csv for a motor, each behind a comma; motor_values() are
/// theirs, in the units of the titles.
void add_motor_titles(std::string& text,
                      const mechanism::ForceElement& element);
std::array<double, 12> motor_values(const mechanism::MotorState& motor);

/// The same at one instant.
nlohmann::ordered_json motor_json(const mechanism::MotorState& motor);

/// Extremes of the motion and the balance of its energy.
nlohmann::ordered_json motor_summary_json(const mechanism::Motion& motion,
                                          std::size_t element);

/// Table of the motors; empty without.
std::string motors_text(const MotionReport& report, Colour colour);

}  // namespace clevis::report
