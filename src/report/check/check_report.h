#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assessment/job/part_result.h"
#include "base/messages/errors.h"
#include "part/part_definition.h"
#include "part/verdict.h"
#include "report/check/check_inputs.h"
#include "report/machine/bearing_output.h"
#include "report/summary/mechanism_summary.h"

namespace clevis::report {

/// A part that could not be computed: its check ended with an Error.
struct PartFailure {
  std::string name;
  Error error;
};

/// Everything that `clevis check` tells: the source of the table and of all
/// files. SI; the writers convert to the units that their columns and keys
/// name.
struct CheckReport {
  std::string version;  ///< of clevis
  std::string scene;    ///< the scene's name
  std::filesystem::path file;
  CheckInputs inputs;
  std::optional<MechanismSummary> mechanism;  ///< absent: only [[part.case]]
  std::vector<assessment::PartResult> parts;
  std::vector<PartFailure> failures;
  std::vector<BearingReport> bearings;
  /// Limits of the user, by part; a part without limits may be absent.
  std::map<std::string, part::Limits> limits;
  /// False if parts are missing because the user interrupted the check.
  bool complete = true;
  /// Phases in their order, and "total".
  std::vector<std::pair<std::string, double>> seconds;
};

/// Fail if a part or bearing fails; else not judged if one is not judged, could
/// not be computed or was not reached; else pass.
part::Verdict overall_verdict(const CheckReport& report);

/// Exit code of the process: that of the first failure if there is one, else
/// by the overall verdict.
ExitCode exit_code(const CheckReport& report);

}  // namespace clevis::report
