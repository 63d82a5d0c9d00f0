#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "beam/estimates/ejector.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Ejector by beam theory, each formula as published in [RotorLine] and
/// corrected.
struct EjectorResult {
  std::string name;
  beam::EjectorDrive published, corrected;
  std::vector<beam::EjectorVariant> variants;
  std::optional<double> condition_published, condition_corrected;  ///< (6) [Pa]
  beam::EjectorLimits limits;
};
EjectorResult ejector_result(const machine::EjectorDefinition& ejector);

/// Everything that `clevis impact` tells.
struct EjectorReport {
  std::string version;  ///< of clevis
  std::string scene;    ///< the scene's name
  std::vector<EjectorResult> ejectors;
};

std::string ejector_text(const EjectorReport& report, Colour colour);

/// One JSON document; keys name their units. @throws Error F003.
std::string ejector_json(const EjectorReport& report);

/// One row per variant of the formulas.
std::string ejector_csv(const EjectorReport& report);

/// Writes impact.csv and, last, impact.json. @throws Error I002.
void write_ejector_files(const EjectorReport& report,
                         const std::filesystem::path& folder);

}  // namespace clevis::report
