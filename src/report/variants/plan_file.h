#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "report/check/check_inputs.h"

namespace clevis::report {

/// A variant that a plan expects.
struct PlannedVariant {
  std::string name;    ///< of its folder
  CheckInputs inputs;  ///< of its check, without version and meshes
};

/// Plan that `clevis plan` leaves for `clevis collect`.
struct Plan {
  std::string version;  ///< of clevis
  std::string scene;    ///< the scene's name
  std::filesystem::path file;
  std::vector<PlannedVariant> variants;
};

/// The file of a plan in the folder of its variants.
inline constexpr std::string_view kPlanFile = "plan.json";

std::string plan_json(const Plan& plan);

/// @throws Error I007 if the folder has no plan, I003 if it is damaged.
Plan read_plan(const std::filesystem::path& folder);

}  // namespace clevis::report
