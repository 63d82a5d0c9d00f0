#pragma once

#include <array>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "report/summary/motion_report.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Columns of forces.csv for the chambers of a gas cylinder, each behind a
/// comma; chamber_values() are theirs, in the units of the titles.
void add_chamber_titles(std::string& text,
                        const mechanism::ForceElement& element);
std::array<double, 8> chamber_values(const mechanism::GasChamberState& chamber);

/// Columns for the interface of gas that is coupled in steps, likewise in the
/// units of the titles.
void add_interface_titles(std::string& text,
                          const mechanism::ForceElement& element);
std::array<double, 5> interface_values(
    const mechanism::GasInterface& interface);

/// Energy error of the communication's steps.
nlohmann::ordered_json interface_summary_json(
    const mechanism::Motion& motion, std::size_t element,
    const mechanism::ForceElement& force);

/// By chamber the same at one instant.
nlohmann::ordered_json chambers_json(const mechanism::ForceElement& element,
                                     const mechanism::ElementState& state);

/// By chamber the extremes of the motion and the balance of its mass.
nlohmann::ordered_json gas_summary_json(const mechanism::Motion& motion,
                                        std::size_t element,
                                        const mechanism::ForceElement& force);

/// Table of the chambers; empty without gas.
std::string gas_text(const MotionReport& report, Colour colour);

}  // namespace clevis::report
