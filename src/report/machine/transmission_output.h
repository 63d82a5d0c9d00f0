#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "machine/transmissions/transmission.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Everything that `clevis transmission` tells.
struct TransmissionReport {
  std::string version;  ///< of clevis
  std::string scene;    ///< the scene's name
  std::vector<machine::TransmissionResult> transmissions;
};

std::string transmission_text(const TransmissionReport& report, Colour colour);

/// One JSON document; keys name their units. @throws Error F003.
std::string transmission_json(const TransmissionReport& report);

/// One row per element.
std::string transmission_csv(const TransmissionReport& report);

/// Writes transmission.csv and, last, transmission.json. @throws Error I002.
void write_transmission_files(const TransmissionReport& report,
                              const std::filesystem::path& folder);

}  // namespace clevis::report
