#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "study/run.h"

namespace clevis::study {

/// Output of the whole command.
struct Study {
  std::string version, scene;
  std::vector<PartStudy> parts;
  std::string calculix;  ///< "CalculiX 2.20", or why it is not there
  bool complete = true;  ///< false: interrupted
};

/// One line per run, a column per figure, units in the names.
std::string study_csv(const PartStudy& part);

/// docs/study.schema.json.
nlohmann::ordered_json study_json(const Study& study);

/// A run as a worker process hands it over, and back.
std::string encode(const Run& run);
Run decode_run(const std::string& text);

}  // namespace clevis::study
