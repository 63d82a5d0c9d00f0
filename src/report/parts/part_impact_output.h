#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "assessment/job/part_result.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Blows on a part by all models, and how fast impacts of the mechanism load
/// it; empty without either.
std::string part_impacts_text(const assessment::PartResult& part,
                              Colour colour);

nlohmann::ordered_json part_impacts_json(const assessment::PartResult& part);
nlohmann::ordered_json duration_ratios_json(const assessment::PartResult& part);
/// Null where the loads of the instants suffice.
nlohmann::ordered_json vibration_json(const assessment::PartResult& part);

/// Nominal stress of the section at which the part is held.
std::string support_section_text(const assessment::SupportStress& held);

/// Stress by the corrected beam-theory impact model, the largest of the blows
/// [Pa], and its factor over the static stress; absent: it says nothing.
struct BeamImpactSummary {
  std::optional<double> stress, factor;
};
BeamImpactSummary beam_impact(const assessment::PartResult& part);

}  // namespace clevis::report
