#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "mechanism/definition/definition.h"
#include "report/machine/bearing_report.h"
#include "report/text/terminal.h"

namespace clevis::report {

std::vector<BearingReport> bearing_reports(
    const std::vector<machine::BearingResult>& results,
    const mechanism::MechanismDefinition& definition);

/// A table with the warnings and reasons below; empty without bearings.
std::string bearings_text(const std::vector<BearingReport>& bearings,
                          Colour colour);

/// An array of what docs/result.schema.json calls a bearing.
nlohmann::ordered_json bearings_json(
    const std::vector<BearingReport>& bearings);

/// One row per bearing, units in the header.
std::string bearings_csv(const std::vector<BearingReport>& bearings);

}  // namespace clevis::report
